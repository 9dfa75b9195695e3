//! Who solves the levels.

use crate::external::External;
use serde::{Deserialize, Serialize};
use signorini_contact::solver::Method;

/// Who solves the levels. References are always solved here.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Solver {
    /// A method of this program.
    Own(#[serde(with = "by_name")] Method),
    /// Another program.
    External(External),
}

impl Solver {
    /// The method, if it is one of this program.
    pub fn own(&self) -> Option<Method> {
        if let Self::Own(method) = self { Some(*method) } else { None }
    }

    /// What tables and plots call it.
    pub fn name(&self) -> &str {
        match self {
            Self::Own(method) => method.name(),
            Self::External(external) => &external.name,
        }
    }
}

impl From<Method> for Solver {
    fn from(method: Method) -> Self {
        Self::Own(method)
    }
}

/// A method by its name.
mod by_name {
    use super::Method;
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    const METHODS: [Method; 5] =
        [Method::Automatic, Method::Condensed, Method::Monotone, Method::InteriorPoint, Method::Multigrid];

    pub(super) fn serialize<S: Serializer>(method: &Method, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(method.name())
    }

    pub(super) fn deserialize<'d, D: Deserializer<'d>>(from: D) -> Result<Method, D::Error> {
        let name = String::deserialize(from)?;
        let found = METHODS.into_iter().find(|m| m.name() == name);
        found.ok_or_else(|| D::Error::custom(format!("no solver `{name}`")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::external::Limits;

    #[test]
    fn solvers_survive_the_way_to_another_process() {
        let external = External {
            name: "solve".into(),
            words: vec!["python3".into(), "/x y/solve.py".into()],
            limits: Limits { seconds: 0.1, printed: 10 },
            folder: "out".into(),
            keeps: true,
        };
        for solver in [Method::InteriorPoint.into(), Solver::External(external)] {
            let text = serde_json::to_string(&solver).unwrap();
            assert_eq!(serde_json::from_str::<Solver>(&text).unwrap(), solver, "{text}");
        }
        assert_eq!(serde_json::to_string(&Solver::Own(Method::InteriorPoint)).unwrap(), r#"{"own":"interior-point"}"#);
        let refused = serde_json::from_str::<Solver>(r#"{"own":"magic"}"#).unwrap_err();
        assert!(refused.to_string().contains("no solver `magic`"), "{refused}");
    }
}
