//! Starts `vrts lsp` and `vrts dap`, which have to be on the path.

use zed_extension_api::{
    self as zed, serde_json::Value, Command, DebugAdapterBinary, DebugConfig, DebugRequest,
    DebugScenario, DebugTaskDefinition, LanguageServerId, Result, StartDebuggingRequestArguments,
    StartDebuggingRequestArgumentsRequest, Worktree,
};

struct Vrts;

/// Returns the command, by the path of the folder that is open.
fn vrts(worktree: &Worktree) -> Result<String> {
    worktree
        .which("vrts")
        .ok_or_else(|| "`vrts` is not on the path".into())
}

impl zed::Extension for Vrts {
    fn new() -> Self {
        Vrts
    }

    fn language_server_command(
        &mut self,
        _: &LanguageServerId,
        worktree: &Worktree,
    ) -> Result<Command> {
        Ok(Command {
            command: vrts(worktree)?,
            args: vec!["lsp".into()],
            env: worktree.shell_env(),
        })
    }

    fn get_dap_binary(
        &mut self,
        _: String,
        config: DebugTaskDefinition,
        path: Option<String>,
        worktree: &Worktree,
    ) -> Result<DebugAdapterBinary, String> {
        Ok(DebugAdapterBinary {
            command: Some(path.map_or_else(|| vrts(worktree), Ok)?),
            arguments: vec!["dap".into()],
            envs: worktree.shell_env(),
            cwd: Some(worktree.root_path()),
            connection: None,
            request_args: StartDebuggingRequestArguments {
                configuration: config.config,
                request: StartDebuggingRequestArgumentsRequest::Launch,
            },
        })
    }

    fn dap_request_kind(
        &mut self,
        _: String,
        _: Value,
    ) -> Result<StartDebuggingRequestArgumentsRequest, String> {
        Ok(StartDebuggingRequestArgumentsRequest::Launch)
    }

    fn dap_config_to_scenario(&mut self, config: DebugConfig) -> Result<DebugScenario, String> {
        let DebugRequest::Launch(launch) = config.request else {
            return Err("programs are started, there is nothing to attach to".into());
        };
        let asked = zed::serde_json::json!({
            "program": launch.program,
            "stopOnEntry": config.stop_on_entry.unwrap_or(true),
        });
        Ok(DebugScenario {
            label: config.label,
            adapter: config.adapter,
            build: None,
            config: asked.to_string(),
            tcp_connection: None,
        })
    }
}

zed::register_extension!(Vrts);
