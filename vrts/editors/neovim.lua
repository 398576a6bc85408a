vim.api.nvim_create_autocmd({ "BufRead", "BufNewFile" }, { pattern = { "*.v2", "*.pg", "*.lc" }, command = "setf val2" })
local ids = {}; local start = vim.lsp.start or function(c) local r = c.root_dir; c.on_exit = function() ids[r] = nil end; ids[r] = ids[r] or vim.lsp.start_client(c); vim.lsp.buf_attach_client(0, ids[r]) end
vim.api.nvim_create_autocmd("FileType", { pattern = "val2", callback = function() start({ name = "vrts", cmd = { "vrts", "lsp" }, root_dir = vim.fn.getcwd() }) end })

-- the debugger, by the plugin nvim-dap; `debug` above a program starts it, and without it shows the run in a browser
local has_dap, dap = pcall(require, "dap")
if has_dap then
  local launch = { type = "vrts", request = "launch", name = "VAL-II", program = "${file}" }
  dap.adapters.vrts = { type = "executable", command = "vrts", args = { "dap" } }
  dap.configurations.val2 = { launch }
  vim.lsp.commands["vrts.debug"] = function(c)
    dap.run(vim.tbl_extend("force", launch, { program = vim.uri_to_fname(c.arguments[1]), entry = c.arguments[2] }))
  end
end
