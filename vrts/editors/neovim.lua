vim.api.nvim_create_autocmd({ "BufRead", "BufNewFile" }, { pattern = { "*.v2", "*.pg", "*.lc" }, command = "setf val2" })
local ids = {}; local start = vim.lsp.start or function(c) local r = c.root_dir; c.on_exit = function() ids[r] = nil end; ids[r] = ids[r] or vim.lsp.start_client(c); vim.lsp.buf_attach_client(0, ids[r]) end
vim.api.nvim_create_autocmd("FileType", { pattern = "val2", callback = function() start({ name = "vrts", cmd = { "vrts", "lsp" }, root_dir = vim.fn.getcwd() }) end })
