//! The initial `device.toml` of a new device: profile, identity and features, with comments about the next
//! steps.

use super::facts;
use super::keys::{DEVICE, FILE, FORMAT};
use super::profile::{ProfileSaid, implied_device};
use super::words::{push, quoted};
use super::writer::{section, write_features};
use crate::scaffold::{self, BaseError, Wanted};
use objdict_model::model::{Device, FileInfo, PdoKind};

/// The TPDOs that have a CAN-ID without a word.
const PREDEFINED: std::ops::RangeInclusive<u16> = 1..=4;

/// The `device.toml` of a [new device](crate::scaffold::scaffold): its profile, identity and features, with an example of an
/// object and a PDO in comments.
///
/// # Errors
/// See [`crate::scaffold::base()`].
pub fn new_device_toml(wanted: &Wanted) -> Result<String, BaseError> {
    let (profile, features, device) = (wanted.profile, &wanted.features, &scaffold::scaffold(wanted)?);
    let version = scaffold::newest_version(profile).ok_or(BaseError::Profile(profile))?;
    let said = ProfileSaid { profile, version, features: features.clone() };
    let base = scaffold::base(profile, version, features)?;
    let mut text = format!("format = {}\n{}", quoted(FORMAT), said.line());
    // the generated file has a different name
    let file = device.file_info.clone().map(|info| FileInfo { file_name: None, ..info });
    section(&mut text, "file", file.as_ref(), FILE, &facts::implied_file());
    let implied = implied_device(base.device_info.as_ref(), device);
    section(&mut text, "device", device.device_info.as_ref(), DEVICE, &implied);
    write_features(&said, &mut text);
    let demand = if profile == 301 {
        "CiA 301 demands".to_owned()
    } else {
        format!("CiA {profile} and CiA 301 demand")
    };
    text.push_str(&format!(
        "\n# The device has what {demand} for its features; `objdict new -h` lists these.\n"
    ));
    text.push_str(COMMENT);
    for line in example(device).lines() {
        push(&mut text, format!("# {line}").trim_end());
    }
    Ok(text)
}

/// Two objects, a changed default of an existing object, and a PDO.
fn example(device: &Device) -> String {
    let mut text = String::new();
    let is_free =
        |number: &u16| device.pdo(PdoKind::Tpdo, *number).is_none_or(|pdo| pdo.mapped().next().is_none());
    if let Some(number) = PREDEFINED.into_iter().find(is_free) {
        text.push_str(&format!("[tpdo.{number}]\nmap = [\"2000\"]\nevent-timer = \"100ms\"\n\n"));
    }
    text.push_str("[object]\n");
    if device.object(0x1017).is_some() {
        text.push_str("1017 = { default = 500 }\n");
    }
    text.push_str(OBJECTS);
    text
}

const COMMENT: &str = "\
# Other objects, and what is different, are lines below `[object]`; PDOs are tables. Without `# ` this is an example.
# Editors know the keys by the schema that `objdict schema device` prints; docs/reference/device.md explains them.
#
";

const OBJECTS: &str = r#"2000 = { name = "Temperature", type = "i16", access = "ro", map = "tpdo", unit = "°C", factor = 0.1 }
2001 = { name = "Highest temperature", type = "i16", default = 600, min = -400, max = 850, unit = "°C", factor = 0.1 }
"#;
