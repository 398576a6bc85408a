vim.api.nvim_create_autocmd({ "BufRead", "BufNewFile" }, { pattern = { "*.v2", "*.pg", "*.lc" }, command = "setf val2" })
local start = vim.lsp.start or function(c) vim.lsp.buf_attach_client(0, vim.lsp.start_client(c)) end
vim.api.nvim_create_autocmd("FileType", { pattern = "val2", callback = function() start({ name = "vrts", cmd = { "vrts", "lsp" }, root_dir = vim.fn.getcwd() }) end })

-- the debugger, by the plugin nvim-dap
local has_dap, dap = pcall(require, "dap")
if has_dap then dap.adapters.vrts = { type = "executable", command = "vrts", args = { "dap" } } end
if has_dap then dap.configurations.val2 = { { type = "vrts", request = "launch", name = "VAL-II", program = "${file}" } } end
