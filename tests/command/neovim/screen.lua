-- The cells of the screen as rows of runs: text, foreground, background, and whether it is bold.
local function screen()
  local rows = {}
  for row = 0, vim.o.lines - 1 do
    local runs, last = {}, nil
    for column = 0, vim.o.columns - 1 do
      local cell = vim.api.nvim__inspect_cell(1, row, column)
      local look = cell[2] or {}
      local fore, back = look.foreground or -1, look.background or -1
      if look.reverse then fore, back = back, fore end
      local run = { cell[1], fore, back, look.bold and 1 or 0 }
      if last and last[2] == run[2] and last[3] == run[3] and last[4] == run[4] then
        last[1] = last[1] .. run[1]
      else
        last = run
        table.insert(runs, run)
      end
    end
    table.insert(rows, runs)
  end
  return vim.fn.json_encode(rows)
end

-- The text of the window that floats above the others; empty without one.
local function floating()
  for _, window in ipairs(vim.api.nvim_list_wins()) do
    if vim.api.nvim_win_get_config(window).relative ~= '' then
      return table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, true), '\n')
    end
  end
  return ''
end

return { screen = screen, floating = floating }
