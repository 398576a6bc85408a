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
