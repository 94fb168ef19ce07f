//! The names of CiA 311 as small numbers. The tree looks each name up once, when it is built; reading,
//! checking and locating compare numbers.

/// A name of CiA 311. All other names are [`Name::OTHER`], which equals no element or attribute.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name(u16);

/// The size of the hash table: a power of two, several times the number of names.
const PLACES: usize = 1024;

/// The number of each name in its hash slot, or in the next free one.
static TABLE: [u16; PLACES] = {
    let mut table = [0; PLACES];
    let mut number = 1;
    while number < WORDS.len() {
        let mut place = hash(WORDS[number].as_bytes());
        while table[place] != 0 {
            place = (place + 1) % PLACES;
        }
        table[place] = number as u16;
        number += 1;
    }
    table
};

/// Uses the length and the bytes at the ends and in the middle.
const fn hash(name: &[u8]) -> usize {
    let length = name.len();
    if length == 0 {
        return 0;
    }
    let ends = name[0] as usize * 31 + name[length - 1] as usize * 7;
    let middle = name[length / 2] as usize * 131 + name[length / 4] as usize * 17;
    (ends + middle + length * 67) % PLACES
}

impl Name {
    /// Any name that CiA 311 does not have.
    pub const OTHER: Self = Self(0);

    /// The name for a string.
    pub fn of(text: &str) -> Self {
        Self::of_bytes(text.as_bytes())
    }

    /// The name for the bytes of a string.
    pub(super) fn of_bytes(text: &[u8]) -> Self {
        let mut place = hash(text);
        loop {
            let number = TABLE[place];
            if number == 0 || WORDS[number as usize].as_bytes() == text {
                return Self(number);
            }
            place = (place + 1) % PLACES;
        }
    }

    /// The spelling of CiA 311.
    pub const fn text(self) -> &'static str {
        WORDS[self.0 as usize]
    }
}

/// Declares a constant for each name; a name that is a Rust keyword is followed by its spelling.
macro_rules! names {
    ($($name:ident $($text:literal)?)+) => {
        /// One constant for each name.
        #[allow(non_upper_case_globals, missing_docs, reason = "each constant is the name that CiA 311 spells so")]
        pub mod n {
            use super::Name;

            #[allow(non_camel_case_types, dead_code, clippy::enum_variant_names, clippy::upper_case_acronyms, reason = "names as CiA 311 spells them")]
            enum NameNumber { Unknown, $($name),+ }
            $(pub const $name: Name = Name(NameNumber::$name as u16);)+
        }

        static WORDS: &[&str] = &["", $(names!(@ $name $($text)?)),+];
    };
    (@ $name:ident) => { stringify!($name) };
    (@ $name:ident $text:literal) => { $text };
}

names! {
    text "#text" access accessList accessType actualBaudRate actualValue AdditionalInformation address
    addressing addressMax addressMin addressOffset allowedValues allowedValuesTemplate ApplicationLayers
    ApplicationProcess array author baseIndex baudRate bitAlignment BITSTRING BOOL bootUpMaster bootUpSlave
    buildDate BYTE CANopenGeneralFeatures CANopenManager CANopenMasterFeatures CANopenObject CANopenObjectList
    CANopenSubObject capabilities category CHAR characteristic characteristicContent characteristicName
    characteristicsList childID childIDRef combinedState communicationEntityType compliantWith
    conditionalSupport configurationManager configVars conformanceClass connectedModule connectedModuleList
    connection count dataType dataTypeIDRef dataTypeList date defaultValue denotation derived description
    descriptionRef destination deviceClass deviceCommissioning deviceFamily DeviceFunction DeviceIdentity
    DeviceManager dictID dictionary dictionaryList DINT dummy dummyUsage DWORD dynamicChannel dynamicChannels
    endIndex entry r#enum "enum" enumValue ExternalProfileHandle file fileCreationDate fileCreationTime
    fileCreator fileList fileModificationDate fileModificationTime fileModifiedBy fileName fileVersion
    flashingPeriod flyingMaster formatName formatVersion functionInstance functionInstanceList functionType
    functionTypeList granularity groupMessaging highLimit IASInterfaceType identity impulsWidth index
    indicatorList initialValue inputVars instanceIDRef instanceName INT interface interfaceList
    ISO15745Edition ISO15745Part ISO15745Profile ISO15745ProfileContainer ISO15745Reference kindOfAccess label
    labelRef lang layerSettingServiceMaster layerSettingServiceSlave LED LEDcolor LEDcolors LEDList LEDstate
    LEDstateRef LEDtype LINT lowerLimit lowLimit LREAL LWORD mandatoryObjects manufacturerObjects maxChilds
    maxCount maxIndex maxNumber maxSubIndex maxValue memberRef minValue moduleInterface moduleInterfaceList
    moduleManagement moduleType moduleTypeList multipleChilds multiplier name NetworkManagement networkName
    networkNumber NodeID nodeID nodeName nrOfRxPDO nrOfTxPDO number numberOfImpulses objectType objFlags
    offset optionalObjects orderNumber organization outputVars package parameter parameterGroup
    parameterGroupList parameterList parameterRef parameterTemplate paramIDRef PDOmapping persistent
    PhysicalLayer picture picturesList position productFamily productID productName productText ProfileBody
    ProfileClassID ProfileDate ProfileHeader ProfileIdentification ProfileLocation ProfileName ProfileRevision
    ProfileSource ProfileTechnology property range rangeList rangeSelector readOnly REAL SDOManager
    SDORequestingDevice selfStartingDevice signed SINT size sortMode sortNumber sortStep source
    specificationRevision standardComplianceList start startIndex state stateIDRef step STRING
    r#struct "struct" subIndex subNumber subrange substituteValue support supportedBaudRate supportedLanguages
    templateIDRef templateList textID TransportLayers r#type "type" typeIDRef UDINT UINT ULINT uniqueID
    uniqueIDRef unit unitURI unusedSlots upperLimit URI USINT value varDeclaration variableIDRef variableRef
    vendorID vendorName vendorText version versionInfo versionType WORD WSTRING
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_found() {
        for (number, word) in (0..).zip(WORDS).skip(1) {
            assert_eq!(Name::of(word), Name(number), "{word}");
            assert_eq!(Name::of(&format!("{word}x")), Name::OTHER);
        }
        assert_eq!((Name::of(""), Name::of("r#type"), n::r#type.text()), (Name::OTHER, Name::OTHER, "type"));
    }
}
