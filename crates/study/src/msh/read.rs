//! A file of Gmsh, version 4.1, text or binary, as it stands: sections to lists, nothing interpreted.

use super::cursor::{Cursor, Form, shown};
use super::error::MshError;
use super::kind;
use signorini_contact::Point;
use std::collections::{BTreeMap, BTreeSet};

/// What a mesh file says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Msh {
    /// Names of physical groups by dimension and tag.
    pub names: BTreeMap<(i32, i32), String>,
    /// Physical tags of the entities, by dimension and tag.
    pub entities: BTreeMap<(i32, i32), Vec<i32>>,
    /// Nodes by tag.
    pub nodes: BTreeMap<u64, Point>,
    /// Lines, in the order of the file.
    pub lines: Vec<Element<2>>,
    /// Triangles, in the order of the file.
    pub triangles: Vec<Element<3>>,
}

/// A line or a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element<const N: usize> {
    /// Its tag.
    pub tag: u64,
    /// The tag of the entity that it belongs to.
    pub entity: i32,
    /// Tags of its nodes.
    pub nodes: [u64; N],
}

impl Msh {
    /// Reads a file of version 4.1, text or binary. Sections that say nothing of nodes, elements and groups are passed over.
    ///
    /// # Errors
    /// The first thing that makes no sense or that the program does not take, with its line or byte: other versions, partitioned
    /// meshes, files without entities, elements other than points, lines of 2 and triangles of 3 nodes, nodes off the plane.
    pub fn read(bytes: &[u8]) -> Result<Self, MshError> {
        let mut cursor = Cursor::new(bytes);
        let form = format(&mut cursor)?;
        let mut msh = Self::default();
        let mut seen: BTreeSet<&[u8]> = BTreeSet::new();
        while let Some(name) = cursor.word() {
            let known = name.strip_prefix(b"$").filter(|n| !n.is_empty() && !n.starts_with(b"End"));
            let Some(section) = known else {
                let next = "a section begins with its name after a $: correct the count of what stands before it";
                return cursor.refuse(format!("{} where a section should begin", shown(Some(name))), next);
            };
            if !seen.insert(section) && READ.contains(&section) {
                return cursor.refuse(format!("a second section {}", shown(Some(name))), "leave one of them out");
            }
            msh.section(section, &mut cursor, form)?;
        }
        for needed in READ {
            if !seen.contains(needed) {
                let name = String::from_utf8_lossy(needed).into_owned();
                return cursor.refuse(format!("the file has no section ${name}"), missing(needed));
            }
        }
        Ok(msh)
    }

    fn section(&mut self, name: &[u8], cursor: &mut Cursor<'_>, form: Form) -> Result<(), MshError> {
        let end = format!("$End{}", String::from_utf8_lossy(name));
        if PARTITIONED.contains(&name) {
            let message = format!("the mesh is partitioned: it has a section {}", shown(Some(name)));
            return cursor
                .refuse(message, "save it in one piece: Mesh > Unpartition, or gmsh.model.mesh.unpartition()");
        }
        if !READ.contains(&name) {
            let begin = cursor.place();
            if cursor.skip_behind(end.as_bytes()) {
                return Ok(());
            }
            let message = format!("the section {} does not end", shown(Some(name)));
            return Err(MshError::at(begin, message, format!("add {end}")));
        }
        if name != b"PhysicalNames" && form != Form::Text {
            cursor.end_line();
            cursor.form = form;
        }
        match name {
            b"PhysicalNames" => self.physical_names(cursor),
            b"Entities" => self.entities(cursor),
            b"Nodes" => self.nodes(cursor),
            _ => self.elements(cursor),
        }?;
        cursor.form = Form::Text;
        cursor.expect(&end)
    }

    fn physical_names(&mut self, cursor: &mut Cursor<'_>) -> Result<(), MshError> {
        for _ in 0..cursor.size("the number of names")? {
            let key = (cursor.int("a dimension")?, cursor.int("a physical tag")?);
            let quoted = cursor.rest_of_line();
            let inner = quoted.strip_prefix(b"\"").and_then(|q| q.strip_suffix(b"\""));
            let Some(name) = inner.and_then(|n| std::str::from_utf8(n).ok()) else {
                let message = format!("{} is no name between quotation marks", shown(Some(quoted)));
                return cursor.refuse(message, "write 2 1 \"name\": dimension, tag, name");
            };
            self.names.insert(key, name.to_string());
        }
        Ok(())
    }

    fn entities(&mut self, cursor: &mut Cursor<'_>) -> Result<(), MshError> {
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = cursor.size("a number of entities")?;
        }
        for (dimension, count) in counts.into_iter().enumerate() {
            for _ in 0..count {
                let tag = cursor.int("the tag of an entity")?;
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    cursor.real("a coordinate of an entity")?;
                }
                let physical = ints(cursor, "a physical tag")?;
                if dimension > 0 {
                    ints(cursor, "the tag of a bounding entity")?;
                }
                self.entities.insert((dimension as i32, tag), physical);
            }
        }
        Ok(())
    }

    fn nodes(&mut self, cursor: &mut Cursor<'_>) -> Result<(), MshError> {
        let blocks = cursor.size("the number of blocks")?;
        for _ in 0..3 {
            cursor.size("a number of nodes")?;
        }
        for _ in 0..blocks {
            let dimension = cursor.int("a dimension")?;
            cursor.int("the tag of an entity")?;
            let parametric = cursor.int("0 or 1")? != 0;
            let count = cursor.size("a number of nodes")?;
            let mut tags = Vec::new();
            for _ in 0..count {
                tags.push(cursor.size("the tag of a node")?);
            }
            for tag in tags {
                let [x, y, z] = [cursor.real("x")?, cursor.real("y")?, cursor.real("z")?];
                for _ in 0..if parametric { dimension } else { 0 } {
                    cursor.real("a parameter")?;
                }
                if z.abs() > 1e-9 * x.abs().max(y.abs()).max(1e-3) {
                    return cursor.refuse(format!("node {tag} lies at z = {z}"), "the bodies are plane: let z be 0");
                }
                if self.nodes.insert(tag, Point::new(x, y)).is_some() {
                    return cursor.refuse(format!("two nodes have the tag {tag}"), "give each node a tag of its own");
                }
            }
        }
        Ok(())
    }

    fn elements(&mut self, cursor: &mut Cursor<'_>) -> Result<(), MshError> {
        let blocks = cursor.size("the number of blocks")?;
        for _ in 0..3 {
            cursor.size("a number of elements")?;
        }
        for _ in 0..blocks {
            cursor.int("a dimension")?;
            let entity = cursor.int("the tag of an entity")?;
            let number = cursor.int("the kind of an element")?;
            if !kind::TAKEN.contains(&number) {
                let message = format!("entity {entity} consists of {}", kind::name(number));
                return cursor.refuse(message, kind::instead(number));
            }
            for _ in 0..cursor.size("a number of elements")? {
                let tag = cursor.size("the tag of an element")?;
                match number {
                    kind::LINE => self.lines.push(Element { tag, entity, nodes: self.node_tags(cursor, tag)? }),
                    kind::TRIANGLE => self.triangles.push(Element { tag, entity, nodes: self.node_tags(cursor, tag)? }),
                    _ => _ = self.node_tags::<1>(cursor, tag)?,
                }
            }
        }
        Ok(())
    }

    fn node_tags<const N: usize>(&self, cursor: &mut Cursor<'_>, element: u64) -> Result<[u64; N], MshError> {
        let mut nodes = [0; N];
        for node in &mut nodes {
            *node = cursor.size("the tag of a node")?;
            if !self.nodes.contains_key(node) {
                let message = format!("element {element} has the node {node}, which the file does not list");
                return cursor.refuse(message, "let $Nodes come before $Elements and list every node");
            }
        }
        Ok(nodes)
    }
}

/// The sections that are read, and that every file needs.
const READ: [&[u8]; 4] = [b"PhysicalNames", b"Entities", b"Nodes", b"Elements"];

/// Sections of meshes cut into parts.
const PARTITIONED: [&[u8]; 2] = [b"PartitionedEntities", b"GhostElements"];

fn missing(section: &[u8]) -> &'static str {
    match section {
        b"PhysicalNames" => "name the groups in the .geo, e.g. Physical Surface(\"upper\") = {1}; and mesh it again",
        b"Entities" => "groups of nodes and elements are known by their entities: save the mesh from Gmsh, version 4.1",
        _ => "save the mesh itself: gmsh -2 -format msh41",
    }
}

/// The form of the numbers, from the section that every file begins with.
fn format(cursor: &mut Cursor<'_>) -> Result<Form, MshError> {
    const SAVE: &str = "save the mesh as version 4.1: gmsh -2 -format msh41, or Mesh.MshFileVersion = 4.1;";
    let first = cursor.word();
    if first != Some(b"$MeshFormat") {
        return cursor.refuse(format!("the file begins with {}, not with $MeshFormat", shown(first)), SAVE);
    }
    let version = cursor.word();
    if version != Some(b"4.1") {
        return cursor.refuse(format!("version {} of the format, where 4.1 is read", shown(version)), SAVE);
    }
    let (binary, bytes) = (cursor.int("0 for text or 1 for binary")?, cursor.int("the size of a number")?);
    if !(0..=1).contains(&binary) || bytes != 8 {
        return cursor.refuse(
            format!("file type {binary}, numbers of {bytes} bytes"),
            "0 or 1 and 8 are possible: save it again",
        );
    }
    let mut form = Form::Text;
    if binary == 1 {
        cursor.end_line();
        (cursor.form, cursor.binary) = (Form::LittleEndian, true);
        form = match cursor.int("the number 1 in binary")? {
            1 => Form::LittleEndian,
            0x0100_0000 => Form::BigEndian,
            other => return cursor.refuse(format!("{other} where 1 tells the order of bytes"), "save the mesh again"),
        };
        cursor.form = Form::Text;
    }
    cursor.expect("$EndMeshFormat")?;
    Ok(form)
}

/// A count and as many whole numbers.
fn ints(cursor: &mut Cursor<'_>, what: &str) -> Result<Vec<i32>, MshError> {
    (0..cursor.size("a count")?).map(|_| cursor.int(what)).collect()
}
