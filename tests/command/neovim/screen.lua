-- Where the window or the list above the others is drawn; nil without one.
local function above()
  if vim.fn.pumvisible() == 1 then
    local list = vim.fn.pum_getpos()
    return { row = list.row, column = list.col, width = list.width, height = list.height }
  end
  for _, window in ipairs(vim.api.nvim_list_wins()) do
    if vim.api.nvim_win_get_config(window).relative ~= '' then
      local at = vim.api.nvim_win_get_position(window)
      local width, height = vim.api.nvim_win_get_width(window), vim.api.nvim_win_get_height(window)
      return { row = at[1], column = at[2], width = width, height = height }
    end
  end
end

-- Its cells: they are a grid of their own, whose number is not known.
local function grid_above()
  for grid = 2, 100 do
    local is_there, cell = pcall(vim.api.nvim__inspect_cell, grid, 0, 0)
    if is_there and cell[1] then return grid end
  end
end

-- Writes the cells of the screen to `screen.json`, as rows of runs: text, foreground, background, and whether it is bold.
-- A long value of an expression would be shortened where it is printed.
local function screen()
  local shown, grid = above(), grid_above()
  local rows = {}
  for row = 0, vim.o.lines - 1 do
    local runs, last = {}, nil
    for column = 0, vim.o.columns - 1 do
      local cell = vim.api.nvim__inspect_cell(1, row, column)
      if shown and grid then
        local down, right = row - shown.row, column - shown.column
        if down >= 0 and right >= 0 and down < shown.height and right < shown.width then
          -- without a terminal its colours are not known
          cell = { vim.api.nvim__inspect_cell(grid, down, right)[1], { background = 0x303030 } }
        end
      end
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
  vim.fn.writefile({ vim.fn.json_encode(rows) }, 'screen.json')
  return 'written'
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
