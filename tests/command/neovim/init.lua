-- The configuration of a user of Neovim 0.7, whose functions for language servers are older than those of docs/guides/editors.md.
vim.o.termguicolors = true
vim.o.columns, vim.o.lines = 124, 22
vim.o.completeopt = 'menuone,noinsert'
vim.o.shortmess = vim.o.shortmess .. 'cF'
vim.o.swapfile, vim.o.ruler, vim.o.laststatus = false, false, 0
vim.g.loaded_matchparen = 1
vim.cmd('highlight SignColumn guibg=NONE')
-- the first action is taken, as by a user who confirms the menu
vim.ui.select = function(items, _, choose) choose(items[1], 1) end
vim.api.nvim_create_autocmd({ 'BufReadPost', 'BufNewFile' }, {
  pattern = { '*.eds', '*.dcf' },
  callback = function(event)
    vim.bo.filetype = 'dosini'
    vim.bo.omnifunc = 'v:lua.vim.lsp.omnifunc'
    local client = vim.lsp.start_client({ name = 'objdict', cmd = { vim.env.OBJDICT, 'lsp' }, root_dir = vim.fn.getcwd() })
    vim.lsp.buf_attach_client(event.buf, client)
  end,
})
