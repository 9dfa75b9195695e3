//! What stands below the options of `--help`: examples, files, exit status.

/// Below the help of the program.
pub const PROGRAM: &str = "\
First steps:
  signorini list                           what there is: studies, and the claims that they judge
  signorini run theorem-3-1-smooth         one study: a verdict here, tables and plots in reports/
  signorini explain theorem-3-1            the claim behind it: hypotheses, bounds, sources
  signorini new my-press                   a commented study file of your own, ready to run
  signorini                                every study, in about a minute and a half

Exit status: 0 all pass · 1 a gate failed · 2 could not judge, or bad input · 130 interrupted";

/// Below the help of `run`.
pub const RUN: &str = "\
Examples:
  signorini run                                              every study in studies/, quick profile
  signorini run theorem-3-1-natural --levels 4               four levels, coarsest first
  signorini run my-press.toml --out /tmp/mine                a file of your own, results elsewhere
  signorini run two-squares --set body.*.material.poisson=0.45
  signorini run two-squares --sweep body.lower.material.young=0.1,1,10
  signorini run two-squares --solver 'python3 my_solver.py'  your solver, judged like ours
  signorini run --strict --junit junit.xml --annotations github
                                                             a gate for continuous integration
  signorini run hard                                         where contact codes break

Files, in the folder that --out names: summary.md, summary.tex and summary.json for all cases; for each case report.md,
table.csv, table.json, table.tex, plots and record.json.

Ctrl-C lets the levels that run come to their end and keeps them: the same command goes on from there. Ctrl-C again quits.

Exit status: 0 all pass · 1 a gate failed, or drift with --strict · 2 could not judge, or bad input · 130 interrupted";

/// Below the help of `new`.
pub const NEW: &str = "\
Examples:
  signorini new my-press                      errors against a finer mesh
  signorini new my-theorem --reference exact  errors against an exact solution

The file goes into studies/ where that folder is here, else into the current folder. Its first line names the JSON Schema,
so that an editor with Taplo (Even Better TOML) completes and checks it; where no schema is at hand one is written beside it.";

/// Below the help of `schema`.
pub const SCHEMA: &str = "\
Example: an editor with Taplo (Even Better TOML) completes and checks a study file whose first line is
  #:schema ./study.schema.json
after
  signorini schema study > study.schema.json";

/// Below the help of `completions`.
pub const COMPLETIONS: &str = "\
Examples:
  signorini completions bash > ~/.local/share/bash-completion/completions/signorini
  signorini completions zsh > ~/.zfunc/_signorini
  signorini completions fish > ~/.config/fish/completions/signorini.fish";

/// Below the help of `explain`.
pub const EXPLAIN: &str = "\
Example:
  signorini explain theorem-3-3               `signorini list` shows every claim";

/// Below the help of `falsify`.
pub const FALSIFY: &str = "\
Example:
  signorini falsify theorem-3-1 --budget 200  200 scenes, the worst kept in reports/falsify/theorem-3-1/";

/// Below the help of `bench`.
pub const BENCH: &str = "\
Examples:
  signorini bench                             every solver on two studies, half a minute
  signorini bench two-squares --max-dofs 1e7 --solvers multigrid";
