//! Headings and text of the documentation in the supported languages. Sentences with numbers are in the code
//! that builds them.

use crate::Language;

macro_rules! texts {
    ($($name:ident: $english:literal, $german:literal;)+) => {
        /// Headings and text in one language.
        pub(crate) struct LanguageTexts {
            $(pub(crate) $name: &'static str,)+
        }

        static ENGLISH: LanguageTexts = LanguageTexts { $($name: $english,)+ };
        static GERMAN: LanguageTexts = LanguageTexts { $($name: $german,)+ };
    };
}

impl LanguageTexts {
    /// Returns the texts of a language.
    pub(crate) fn of(language: Language) -> &'static Self {
        match language {
            Language::English => &ENGLISH,
            Language::German => &GERMAN,
        }
    }
}

texts! {
    // parts of the page
    contents: "Contents", "Inhalt";
    to_objects: "Skip to the objects", "Zu den Objekten springen";
    device: "Device", "Gerät";
    open_workbench: "Open the workbench", "Werkbank öffnen";
    open_there: "and choose this file there:", "und dort diese Datei wählen:";
    findings: "Findings", "Befunde";
    communication: "Communication", "Kommunikation";
    pdos: "PDOs", "PDOs";
    connections: "Connection set", "CAN-Identifier";
    objects: "Objects", "Objekte";
    groups: "Parameter groups", "Parametergruppen";
    // the device
    vendor: "Vendor", "Hersteller";
    vendor_id: "Vendor-ID", "Hersteller-ID";
    product: "Product", "Produkt";
    product_code: "Product code", "Produktcode";
    revision: "Revision number", "Revisionsnummer";
    serial_number: "Serial number", "Seriennummer";
    order_code: "Order code", "Bestellnummer";
    family: "Family", "Gerätefamilie";
    versions: "Versions", "Versionen";
    profile: "Device profile", "Geräteprofil";
    node: "Node", "Knoten";
    node_id: "Node-ID", "Knotennummer";
    network: "Network", "Netzwerk";
    bit_rates: "Bit rates", "Bitraten";
    bit_rate: "Bit rate", "Bitrate";
    features: "Features", "Eigenschaften";
    description: "Description", "Beschreibung";
    file: "File", "Datei";
    created: "Created", "Erstellt";
    modified: "Modified", "Geändert";
    version: "Version", "Version";
    eds_version: "EDS version", "EDS-Version";
    made_from: "Made from", "Abgeleitet von";
    comments: "Comments", "Kommentare";
    further_keys: "Further keys of the file", "Weitere Schlüssel der Datei";
    modules: "Modules", "Module";
    made_by: "Made by", "Erzeugt mit";
    // objects
    filter: "Filter objects", "Objekte filtern";
    filter_hint: "index, name, type, access", "Index, Name, Typ, Zugriff";
    nothing_found: "nothing found", "nichts gefunden";
    copy: "Copy", "Kopieren";
    expand: "Expand all", "Alle aufklappen";
    collapse: "Collapse arrays", "Arrays zuklappen";
    index: "Index", "Index";
    sub: "Sub", "Sub";
    name: "Name", "Name";
    object_type: "Object", "Objekt";
    data_type: "Type", "Typ";
    access: "Access", "Zugriff";
    pdo: "PDO", "PDO";
    default: "Default", "Vorgabe";
    value: "Value", "Wert";
    limits: "limits", "Grenzen";
    unit: "unit", "Einheit";
    mapped: "mapped in", "gemappt in";
    bit: "bit", "Bit";
    bits: "Bits", "Bits";
    bits_as: "bits as in", "Bits wie in";
    allowed: "allowed by CiA", "nach CiA erlaubt";
    denotation: "denotation", "Bezeichnung";
    links: "see also", "siehe auch";
    not_described: "(not described)", "(nicht beschrieben)";
    no_name: "(no name)", "(ohne Namen)";
    // communication
    mapping: "Mapping", "Mapping";
    unused: "unused", "unbenutzt";
    byte_and_bit: "Byte.bit", "Byte.Bit";
    length: "Bits", "Bits";
    service: "Service", "Dienst";
    direction: "The device", "Das Gerät";
    predefined: "Predefined", "Vordefiniert";
    own_can_id: "This device", "Dieses Gerät";
    sends: "sends", "sendet";
    receives: "receives", "empfängt";
    sends_and_receives: "sends and receives", "sendet und empfängt";
    differs: "not the predefined one", "nicht der vordefinierte";
    not_valid: "not valid", "ungültig";
    not_stated: "not stated", "nicht angegeben";
    absent: "not supported", "nicht unterstützt";
    downloads: "Downloads", "Downloads";
    sent_in_this_order: "These values are sent to the node in this order. PDOs and other services are marked not valid before they change.", "Der Knoten bekommt diese Werte in dieser Reihenfolge. PDOs und andere Dienste werden ungültig, bevor sie sich ändern.";
    number: "No.", "Nr.";
    entry: "Entry", "Eintrag";
    states: "State machine", "Zustandsmaschine";
    state: "State", "Zustand";
    command: "Command", "Kommando";
    from: "From", "Von";
    to: "To", "Nach";
    by: "By", "Durch";
    error_codes: "Error codes", "Fehlercodes";
    code: "Code", "Code";
    // areas of the dictionary
    data_types: "Data types", "Datentypen";
    communication_area: "Communication profile", "Kommunikationsprofil";
    manufacturer_area: "Manufacturer-specific", "Herstellerspezifisch";
    profile_area: "Device profile", "Geräteprofil";
    logical_device: "logical device", "logisches Gerät";
    network_area: "Network variables", "Netzwerkvariablen";
    system_area: "System variables", "Systemvariablen";
    reserved_area: "Reserved", "Reserviert";
    // findings
    no_findings: "No findings.", "Keine Befunde.";
    not_checked: "Not checked.", "Nicht geprüft.";
    error: "error", "Fehler";
    warning: "warning", "Warnung";
    note: "note", "Hinweis";
    line: "line", "Zeile";
    also_at: "also at", "auch bei";
    // several devices
    devices: "Devices", "Geräte";
    nodes: "nodes", "Knoten";
    entries: "Entries", "Einträge";
    bold_differs: "Values in bold are configured and differ from the default.", "Fett gedruckte Werte sind konfiguriert und weichen von der Vorgabe ab.";
    counted_objects: "objects", "Objekte";
    counted_entries: "entries", "Einträge";
    errors: "Errors", "Fehler";
    warnings: "Warnings", "Warnungen";
    notes: "Notes", "Hinweise";
    sent_by: "Sent by", "Gesendet von";
    received_by: "Received by", "Empfangen von";
    doubled: "several nodes with the node-ID", "mehrere Knoten mit der Knotennummer";
    sent_twice: "sent by several nodes", "mehrfach gesendet";
    from_to: "From ↓ to →", "Von ↓ an →";
    all_objects: "Objects of all devices", "Objekte aller Geräte";
    search_all: "Filter devices, search objects", "Geräte filtern, Objekte suchen";
    search_hint: "device, index, name", "Gerät, Index, Name";
    too_short: "expects more", "erwartet mehr";
    overview: "Overview", "Übersicht";
    // networks
    topology: "Topology", "Topologie";
    bus_load: "cyclic messages take up to", "zyklische Nachrichten belegen bis zu";
    not_counted: "Not counted", "Nicht mitgezählt";
    load_average: "Load on average", "Buslast im Mittel";
    load_worst: "in the worst case", "höchstens";
    fits_from: "the network fits from", "das Netzwerk passt ab";
    timeline: "Messages over time, if all come at once", "Zeitverlauf der Nachrichten, wenn alle gleichzeitig kommen";
    response: "Response", "Antwortzeit";
    deadline: "Deadline", "Frist";
    unbounded: "unbounded", "unbegrenzt";
    may_be_late: "may be late", "evtl. zu spät";
    network_nodes: "Nodes", "Knoten";
    manager: "manager", "Manager";
    heartbeat: "Heartbeat", "Heartbeat";
    guarding: "Guarding", "Guarding";
    bytes: "Bytes", "Bytes";
    matrix: "Who sends to whom", "Wer sendet an wen";
    network_links: "Links", "Verbindungen";
    no_node: "no node", "kein Knoten";
    source: "Source", "Quelle";
    destination: "Destination", "Ziel";
    messages: "CAN-IDs, highest priority first", "CAN-IDs, höchste Priorität zuerst";
    trigger: "Trigger", "Auslöser";
    period: "Period", "Periode";
    boot_plan: "Boot plan", "Hochlauf";
    steps: "Steps", "Schritte";
    mandatory: "mandatory", "notwendig";
    optional: "optional", "optional";
}
