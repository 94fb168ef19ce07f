//! Locates the parts of a description in a tree: containers, profiles, bodies.

use super::defaults;
use super::profile_class::ProfileClass;
use super::schema::container::DEVICE_BODY;
use super::schema::{DEVICE_HEADER, NETWORK_BODY, NETWORK_HEADER, Shape};
use crate::model::{FileInfo, ProfileHeader};
use crate::xml::{Element, Name, Tree, n};

impl ProfileClass {
    /// The `ProfileBody` of this class.
    pub(crate) const fn body(self) -> &'static Shape<FileInfo> {
        self.pick(&DEVICE_BODY, &NETWORK_BODY)
    }

    /// The `ProfileHeader` of this class.
    pub(crate) const fn header(self) -> &'static Shape<ProfileHeader> {
        self.pick(&DEVICE_HEADER, &NETWORK_HEADER)
    }

    /// The placeholder for a missing header.
    pub(crate) fn unstated_header(self) -> ProfileHeader {
        defaults::header(self.pick("CANopen device profile", "CANopen communication network profile"))
    }
}

/// One description: a container with the profiles of one device.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout<'a> {
    /// The element around the profiles.
    pub(crate) container: Element<'a>,
    /// The device profile.
    pub(crate) device: Option<DescriptionProfile<'a>>,
    /// The communication network profile.
    pub(crate) network: Option<DescriptionProfile<'a>>,
}

/// A profile of a description.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DescriptionProfile<'a> {
    /// `ProfileHeader`.
    pub(crate) header: Option<Element<'a>>,
    /// `ProfileBody`.
    pub(crate) body: Element<'a>,
}

/// The containers of a tree. A description has one; a project of CANopenEditor has one for each device. In a
/// malformed file without a container, the root is used instead.
pub fn containers(tree: &Tree) -> Vec<Element<'_>> {
    let Some(root) = tree.root() else { return Vec::new() };
    if root.tag() == n::ISO15745ProfileContainer {
        return vec![root];
    }
    let inner: Vec<_> =
        root.descendants().filter(|element| element.tag() == n::ISO15745ProfileContainer).collect();
    if inner.is_empty() { vec![root] } else { inner }
}

/// The root element of a CANopenNode editor project from before XDD.
const PROJECT: &str = "device";

/// Whether a document is a project of the editors for CANopenNode from before XDD.
pub fn is_project(tree: &Tree) -> bool {
    tree.root().is_some_and(|root| root.name() == PROJECT)
}

/// Whether a document is a network: descriptions inside a common element.
pub fn is_network(tree: &Tree) -> bool {
    containers(tree).first().is_some_and(|container| container.parent().is_some())
}

impl<'a> Layout<'a> {
    /// One of the [`containers`] of a tree.
    pub(crate) fn of(tree: &'a Tree, number: usize) -> Option<Self> {
        containers(tree).get(number).copied().map(Self::of_container)
    }

    /// The layout of a document whose root is the container.
    pub(crate) fn of_document(tree: &'a Tree) -> Option<Self> {
        tree.root().filter(|root| root.tag() == n::ISO15745ProfileContainer).map(Self::of_container)
    }

    /// The profiles in a container. Of two profiles of one class, the first is used.
    pub(crate) fn of_container(container: Element<'a>) -> Self {
        let mut layout = Self { container, device: None, network: None };
        for (class, profile) in profiles(container) {
            let place = match class {
                ProfileClass::Device => &mut layout.device,
                ProfileClass::Network => &mut layout.network,
            };
            place.get_or_insert(profile);
        }
        layout
    }

    /// An element of the device profile, by its path of names.
    pub(crate) fn in_device(&self, path: &[Name]) -> Option<Element<'a>> {
        below(self.device?.body, path)
    }

    /// An element of the communication network profile, by its path of names.
    pub(crate) fn in_network(&self, path: &[Name]) -> Option<Element<'a>> {
        below(self.network?.body, path)
    }

    /// The device of a [project](is_project).
    pub(crate) fn project(&self) -> Option<Element<'a>> {
        Some(self.container).filter(|root| root.name() == PROJECT && root.parent().is_none())
    }

    /// The objects, in order.
    pub(crate) fn objects(&self) -> impl Iterator<Item = Element<'a>> + use<'a> {
        let list = self.in_network(&[n::ApplicationLayers, n::CANopenObjectList]);
        let list = list.or_else(|| self.project()?.child(n::CANopenObjectList));
        list.into_iter().flat_map(|list| list.children_named(n::CANopenObject))
    }
}

/// An object and its sub-objects.
pub(crate) fn with_subs<'a>(object: Element<'a>) -> impl Iterator<Item = Element<'a>> + use<'a> {
    std::iter::once(object).chain(object.children_named(n::CANopenSubObject))
}

/// The element at a path of names; the first one if there are several.
pub(crate) fn below<'a>(element: Element<'a>, path: &[Name]) -> Option<Element<'a>> {
    path.iter().try_fold(element, |element, name| element.child(*name))
}

/// The profiles of a container with their classes, in order. In a malformed file a profile or a body may be
/// the container.
fn profiles<'a>(container: Element<'a>) -> Vec<(ProfileClass, DescriptionProfile<'a>)> {
    let bodies = |parent: Element<'a>| match parent.tag() {
        n::ISO15745Profile => parent.children_named(n::ProfileBody).collect(),
        n::ProfileBody => vec![parent],
        _ => Vec::new(),
    };
    let found = match container.tag() {
        n::ISO15745Profile | n::ProfileBody => bodies(container),
        _ => container.children().flat_map(bodies).collect(),
    };
    let profile = |body: Element<'a>| {
        let around = body.parent().filter(|around| around.tag() == n::ISO15745Profile);
        let header = around.and_then(|around| around.child(n::ProfileHeader));
        (class_of(header, body), DescriptionProfile { header, body })
    };
    found.into_iter().map(profile).collect()
}

/// The class of a profile: by the type of its body, otherwise by its header or content.
fn class_of(header: Option<Element<'_>>, body: Element<'_>) -> ProfileClass {
    let of_word = |word: &str| {
        let classes = [ProfileClass::Network, ProfileClass::Device];
        classes.into_iter().find(|class| word.contains(class.name()))
    };
    let by_type = body.attribute(n::r#type).and_then(|name| of_word(&name.value()));
    let class = header.and_then(|header| header.child(n::ProfileClassID));
    let by_class = || class.and_then(|class| of_word(&class.text()));
    let by_content = || {
        let is_network = body.children().any(|child| NETWORK_BODY.slot(child.tag(), 0).is_some());
        if is_network { ProfileClass::Network } else { ProfileClass::Device }
    };
    by_type.or_else(by_class).unwrap_or_else(by_content)
}
