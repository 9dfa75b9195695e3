//! `signorini completions` and `signorini man`: what shells and `man` read, from the arguments themselves.

use crate::args::Cli;
use crate::failure::Failure;
use clap::{Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;
use signorini_study::store;
use std::io::{self, Write};
use std::path::Path;

const NAME: &str = "signorini";

/// Prints the completions of a shell.
pub fn completions(shell: Shell) -> Result<u8, Failure> {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), NAME, &mut text);
    put(&text);
    Ok(0)
}

/// Prints the man page; with a folder writes it there, with a page for each command.
pub fn man(out: Option<&Path>) -> Result<u8, Failure> {
    let mut program = Cli::command();
    program.build();
    let Some(out) = out else {
        put(&page(program).map_err(unwritten)?);
        return Ok(0);
    };
    let commands: Vec<Command> = program.get_subcommands().filter(|c| !c.is_hide_set()).cloned().collect();
    write(out, NAME, page(program))?;
    for command in commands {
        let name = format!("{NAME}-{}", command.get_name());
        write(out, &name, page(command))?;
    }
    Ok(0)
}

fn page(command: Command) -> io::Result<Vec<u8>> {
    let mut text = Vec::new();
    Man::new(command).render(&mut text)?;
    Ok(text)
}

fn write(out: &Path, name: &str, page: io::Result<Vec<u8>>) -> Result<(), Failure> {
    let path = out.join(format!("{name}.1"));
    store::write_atomic(&path, page.map_err(unwritten)?)?;
    sayln!("{}", path.display());
    Ok(())
}

fn unwritten(e: io::Error) -> Failure {
    Failure::new(format!("the man page cannot be made: {e}"), "use `signorini --help`")
}

/// To a reader who may have left.
fn put(text: &[u8]) {
    let _ = io::stdout().write_all(text);
}
