//! Which levels keep their fields.

use super::Fields;

/// Which levels of a case keep their fields.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Keep {
    /// None.
    #[default]
    None,
    /// The one that is drawn on the page: the finest with at most [`Keep::DRAWN`] triangles, or else the coarsest.
    Page,
    /// The finest.
    Last,
    /// All.
    All,
    /// These, by number from 0.
    Levels(Vec<usize>),
}

impl Keep {
    /// Triangles whose sides can still be told apart in a picture.
    pub const DRAWN: usize = 3200;

    /// Whether level `level` of `levels`, with so many triangles, is kept for the time being.
    pub fn wants(&self, level: usize, levels: usize, triangles: usize) -> bool {
        match self {
            Self::None => false,
            Self::Page => level == 0 || triangles <= Self::DRAWN,
            Self::Last => level + 1 == levels,
            Self::All => true,
            Self::Levels(these) => these.contains(&level),
        }
    }

    /// Whether levels were asked for by name.
    pub fn asks(&self) -> bool {
        !matches!(self, Self::None | Self::Page)
    }

    /// What is kept in the end of the fields that were collected, coarsest first.
    pub fn finally(&self, mut collected: Vec<Fields>) -> Vec<Fields> {
        if *self == Self::Page
            && let Some(page) = page_level(&collected)
        {
            let page = collected.swap_remove(page);
            return vec![page];
        }
        collected.iter_mut().for_each(|f| f.asked = self.asks());
        collected
    }
}

/// The number in the list of the level that is drawn on the page, the finest with few enough triangles.
pub fn page_level(fields: &[Fields]) -> Option<usize> {
    let few = fields.iter().rposition(|f| f.triangles.len() <= Keep::DRAWN);
    few.or(if fields.is_empty() { None } else { Some(0) })
}
