//! What the supports leave free at the nodes.

use crate::geometry::Vec2;
use std::collections::BTreeMap;

/// What a node may do: the orthonormal directions left free and the prescribed displacement.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeSupport {
    /// Free directions: two, one (on `Γ_0`) or none (on `Γ_u`).
    pub free: Vec<Vec2>,
    /// The prescribed part `u_D`, zero unless on `Γ_u`.
    pub offset: Vec2,
}

impl NodeSupport {
    /// A node that is not held.
    pub fn unsupported() -> Self {
        Self { free: vec![Vec2::x(), Vec2::y()], offset: Vec2::zeros() }
    }
}

/// The supports of all nodes. Few nodes of a mesh are held, so only those are stored.
#[derive(Clone, Debug)]
pub struct NodeSupports {
    nodes: usize,
    held: BTreeMap<u32, NodeSupport>,
    unsupported: NodeSupport,
}

impl NodeSupports {
    /// A mesh of so many nodes, none of them held.
    pub fn new(nodes: usize) -> Self {
        Self { nodes, held: BTreeMap::new(), unsupported: NodeSupport::unsupported() }
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// What `node` may do.
    pub fn of(&self, node: u32) -> &NodeSupport {
        self.held.get(&node).unwrap_or(&self.unsupported)
    }

    /// The support of `node`, to be changed.
    ///
    /// # Panics
    /// If there is no such node.
    pub fn of_mut(&mut self, node: u32) -> &mut NodeSupport {
        assert!((node as usize) < self.nodes, "node {node} of {}", self.nodes);
        self.held.entry(node).or_insert_with(NodeSupport::unsupported)
    }

    /// The nodes that may be held, by ascending number. All others are free.
    pub fn held(&self) -> impl Iterator<Item = (u32, &NodeSupport)> {
        self.held.iter().map(|(node, support)| (*node, support))
    }
}

/// One support for each node.
impl FromIterator<NodeSupport> for NodeSupports {
    fn from_iter<I: IntoIterator<Item = NodeSupport>>(supports: I) -> Self {
        let mut all = Self::new(0);
        for support in supports {
            if support != all.unsupported {
                all.held.insert(all.nodes as u32, support);
            }
            all.nodes += 1;
        }
        all
    }
}
