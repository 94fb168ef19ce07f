//! One page in the browser: what a person does with it, and what can be seen of it.

use std::cell::Cell;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::chromium::{Chromium, PATIENCE};

/// A tab with a profile of its own, closed when it is dropped.
pub(crate) struct Tab {
    chromium: &'static Chromium,
    context: String,
    target: String,
    session: String,
    scripts: Cell<bool>,
}

/// The window that the tests begin with.
const DESKTOP: (u32, u32) = (1280, 900);

impl Tab {
    /// A new tab; `None` where there is no browser.
    pub(crate) fn new() -> Option<Self> {
        let chromium = Chromium::shared()?;
        let text = |value: &Value| value.as_str().unwrap().to_owned();
        let context =
            text(&chromium.call(None, "Target.createBrowserContext", &json!({}))["browserContextId"]);
        let made = json!({ "url": "about:blank", "browserContextId": context });
        let target = text(&chromium.call(None, "Target.createTarget", &made)["targetId"]);
        let attached = json!({ "targetId": target, "flatten": true });
        let session = text(&chromium.call(None, "Target.attachToTarget", &attached)["sessionId"]);
        let tab = Self { chromium, context, target, session, scripts: Cell::new(true) };
        for domain in ["Page", "Runtime", "Log", "Network"] {
            tab.call(&format!("{domain}.enable"), &json!({}));
        }
        // the keyboard and the caret work as in the tab in front
        tab.call("Emulation.setFocusEmulationEnabled", &json!({ "enabled": true }));
        tab.resize(DESKTOP.0, DESKTOP.1);
        Some(tab)
    }

    #[track_caller]
    fn call(&self, method: &str, parameters: &Value) -> Value {
        self.chromium.call(Some(&self.session), method, parameters)
    }

    /// Opens a file, at a fragment (`""` for none), and waits until it is loaded.
    #[track_caller]
    pub(crate) fn open(&self, path: &Path, fragment: &str) {
        let mut url = format!("file://{}", path.display());
        if !fragment.is_empty() {
            url = format!("{url}#{fragment}");
        }
        self.chromium.events(&self.session, &["Page.loadEventFired"]);
        let answer = self.call("Page.navigate", &json!({ "url": url }));
        if let Some(error) = answer["errorText"].as_str() {
            panic!("{url}: {error}");
        }
        // to another place of the same page nothing is loaded
        if answer.get("loaderId").is_some() {
            self.chromium.event(&self.session, "Page.loadEventFired");
        }
        self.settle();
    }

    /// Waits until what was changed is painted. Scripts of the page that wait for a frame have then had theirs.
    #[track_caller]
    pub(crate) fn settle(&self) {
        let painted =
            "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))";
        // no frame calls back where no script runs; there is none to wait for either
        if self.scripts.get() {
            self.eval(painted);
        }
    }

    /// The value of a JavaScript expression, of a promise what it promises.
    #[track_caller]
    pub(crate) fn eval(&self, expression: &str) -> Value {
        let parameters = json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let mut answer = self.call("Runtime.evaluate", &parameters);
        if let Some(thrown) = answer.get("exceptionDetails") {
            panic!("{expression}\n{}", description(thrown));
        }
        answer["result"]["value"].take()
    }

    #[track_caller]
    pub(crate) fn number(&self, expression: &str) -> f64 {
        let value = self.eval(expression);
        value.as_f64().unwrap_or_else(|| panic!("{expression} is {value}, no number"))
    }

    #[track_caller]
    pub(crate) fn text(&self, expression: &str) -> String {
        match self.eval(expression) {
            Value::String(text) => text,
            value => panic!("{expression} is {value}, no text"),
        }
    }

    #[track_caller]
    pub(crate) fn texts(&self, expression: &str) -> Vec<String> {
        let value = self.eval(expression);
        serde_json::from_value(value).unwrap_or_else(|error| panic!("{expression}: {error}"))
    }

    #[track_caller]
    pub(crate) fn is(&self, expression: &str) -> bool {
        match self.eval(expression) {
            Value::Bool(yes) => yes,
            value => panic!("{expression} is {value}, neither true nor false"),
        }
    }

    /// Waits until a condition holds.
    #[track_caller]
    pub(crate) fn wait(&self, condition: &str) {
        let begin = Instant::now();
        while !self.is(condition) {
            assert!(begin.elapsed() < PATIENCE / 4, "{condition} does not become true");
            thread::sleep(Duration::from_millis(10));
        }
    }

    /// Presses and releases a key: one of the names below or a character, with `Shift+` before it where that is held.
    #[track_caller]
    pub(crate) fn press(&self, key: &str) {
        let (modifiers, key) = match key.strip_prefix("Shift+") {
            Some(key) => (8, key),
            None => (0, key),
        };
        let (code, text) = match key {
            "Tab" => (9, ""),
            "Enter" => (13, "\r"),
            "Escape" => (27, ""),
            "Space" => (32, " "),
            "End" => (35, ""),
            "Home" => (36, ""),
            "ArrowLeft" => (37, ""),
            "ArrowUp" => (38, ""),
            "ArrowRight" => (39, ""),
            "ArrowDown" => (40, ""),
            "Backspace" => (8, ""),
            character if character.chars().count() == 1 => (0, character),
            unknown => panic!("no key {unknown}"),
        };
        let name = if key == "Space" { " " } else { key };
        let parameters = |kind: &str, text: &str| {
            json!({ "type": kind, "modifiers": modifiers, "key": name, "code": key, "text": text,
                "windowsVirtualKeyCode": code, "nativeVirtualKeyCode": code })
        };
        let kind = if text.is_empty() { "rawKeyDown" } else { "keyDown" };
        self.call("Input.dispatchKeyEvent", &parameters(kind, text));
        self.call("Input.dispatchKeyEvent", &parameters("keyUp", ""));
        self.settle();
    }

    /// Types a text into what has the focus, key by key.
    #[track_caller]
    pub(crate) fn write(&self, text: &str) {
        for character in text.chars() {
            self.press(character.encode_utf8(&mut [0; 4]));
        }
    }

    /// Clicks at the middle of what a selector finds first, after scrolling to it.
    #[track_caller]
    pub(crate) fn click(&self, selector: &str) {
        let place = || {
            self.eval(&format!(
                "(() => {{
                    const found = document.querySelector({selector:?});
                    if (!found) return null;
                    found.scrollIntoView({{ block: 'center', behavior: 'instant' }});
                    const box = found.getBoundingClientRect();
                    return box.width * box.height && [box.x + box.width / 2, box.y + box.height / 2];
                }})()"
            ))
        };
        let mut found = place();
        // what was out of the window may get its true height only now, and move what is below
        for _ in 0..10 {
            thread::sleep(Duration::from_millis(20));
            self.settle();
            let again = place();
            if again == found {
                break;
            }
            found = again;
        }
        assert!(found.is_array(), "{selector} is not there or has no size: {found}");
        for kind in ["mouseMoved", "mousePressed", "mouseReleased"] {
            let event =
                json!({ "type": kind, "x": found[0], "y": found[1], "button": "left", "clickCount": 1 });
            self.call("Input.dispatchMouseEvent", &event);
        }
        self.settle();
    }

    /// Moves the pointer from one part of the width of what a selector finds to another, with the button held where they differ.
    #[track_caller]
    pub(crate) fn drag(&self, selector: &str, from: f64, to: f64) {
        let place = self.eval(&format!(
            "(() => {{
                const found = document.querySelector({selector:?});
                found.scrollIntoView({{ block: 'center', behavior: 'instant' }});
                const box = found.getBoundingClientRect();
                return [box.x, box.width, box.y + box.height / 2];
            }})()"
        ));
        let [left, width, y] = [0, 1, 2].map(|at| place[at].as_f64().unwrap());
        let step = |kind: &str, part: f64| {
            let buttons = u8::from(from != to && kind != "mouseReleased");
            let event = json!({ "type": kind, "x": left + width * part, "y": y, "button": if kind == "mouseMoved" { "none" } else { "left" },
                "buttons": buttons, "clickCount": 1 });
            self.call("Input.dispatchMouseEvent", &event);
        };
        if from == to {
            step("mouseMoved", to);
        } else {
            for (kind, part) in [("mousePressed", from), ("mouseMoved", to), ("mouseReleased", to)] {
                step(kind, part);
            }
        }
        self.settle();
    }

    /// Turns the wheel by so many pixels at a part of the width of what a selector finds, with Shift held or not.
    #[track_caller]
    pub(crate) fn wheel(&self, selector: &str, part: f64, pixels: i32, is_shifted: bool) {
        let place = self.eval(&format!(
            "(box => [box.x + box.width * {part}, box.y + box.height / 2])(document.querySelector({selector:?}).getBoundingClientRect())"
        ));
        let event = json!({ "type": "mouseWheel", "x": place[0], "y": place[1], "deltaX": 0, "deltaY": pixels,
            "modifiers": if is_shifted { 8 } else { 0 } });
        self.call("Input.dispatchMouseEvent", &event);
        self.settle();
    }

    /// Gives the window a size in CSS pixels.
    #[track_caller]
    pub(crate) fn resize(&self, width: u32, height: u32) {
        let size = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.call("Emulation.setDeviceMetricsOverride", &size);
    }

    /// Shows the page as on this medium (`screen`, `print`) to a person who prefers this colour scheme.
    #[track_caller]
    pub(crate) fn medium(&self, medium: &str, scheme: &str) {
        let features = json!([
            { "name": "prefers-color-scheme", "value": scheme },
            // what moves would be measured on its way
            { "name": "prefers-reduced-motion", "value": "reduce" },
        ]);
        self.call("Emulation.setEmulatedMedia", &json!({ "media": medium, "features": features }));
    }

    /// Pages opened from now on run no script; [`Tab::eval`] still does.
    #[track_caller]
    pub(crate) fn without_script(&self) {
        self.call("Emulation.setScriptExecutionDisabled", &json!({ "value": true }));
        self.scripts.set(false);
    }

    /// The page on paper, as PDF.
    #[track_caller]
    pub(crate) fn pdf(&self) -> Vec<u8> {
        // a medium that was chosen would be that of the paper, too
        self.medium("", "light");
        let paper = json!({ "printBackground": true, "preferCSSPageSize": true, "paperWidth": 8.27, "paperHeight": 11.69 });
        from_base64(self.call("Page.printToPDF", &paper)["data"].as_str().unwrap())
    }

    /// A PNG of the window, or of the whole page.
    #[track_caller]
    pub(crate) fn screenshot(&self, whole: bool) -> Vec<u8> {
        self.eval("document.documentElement.style.scrollbarWidth = 'none'");
        self.settle();
        let mut wanted = json!({ "captureBeyondViewport": whole });
        if whole {
            let size = (self.eval("innerWidth"), self.eval("document.scrollingElement.scrollHeight"));
            wanted["clip"] = json!({ "x": 0, "y": 0, "width": size.0, "height": size.1, "scale": 1 });
        }
        let answer = self.call("Page.captureScreenshot", &wanted);
        self.eval("document.documentElement.style.scrollbarWidth = ''");
        from_base64(answer["data"].as_str().unwrap())
    }

    /// The accessibility tree as a screen reader gets it, in the order of the page.
    #[track_caller]
    pub(crate) fn spoken(&self) -> Vec<Spoken> {
        let answer = self.call("Accessibility.getFullAXTree", &json!({}));
        let text = |node: &Value, key: &str| node[key]["value"].as_str().unwrap_or_default().to_owned();
        let level = |node: &Value| {
            let properties = node["properties"].as_array()?;
            properties.iter().find(|property| property["name"] == "level")?["value"]["value"].as_u64()
        };
        let nodes = answer["nodes"].as_array().unwrap();
        let heard = nodes.iter().filter(|node| node["ignored"] != true);
        heard
            .map(|node| Spoken { role: text(node, "role"), name: text(node, "name"), level: level(node) })
            .collect()
    }

    /// What the page complained of since the last time: exceptions, errors and warnings in the console.
    pub(crate) fn complaints(&self) -> Vec<String> {
        let methods = ["Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded"];
        let mut complaints = Vec::new();
        for event in self.chromium.events(&self.session, &methods) {
            let parameters = &event["params"];
            let complaint = match event["method"].as_str() {
                Some("Runtime.exceptionThrown") => Some(description(&parameters["exceptionDetails"])),
                Some("Runtime.consoleAPICalled") => {
                    let bad = ["error", "warning", "assert"].iter().any(|kind| parameters["type"] == *kind);
                    bad.then(|| parameters["args"].to_string())
                }
                _ => {
                    let entry = &parameters["entry"];
                    let bad = entry["level"] == "error" || entry["level"] == "warning";
                    bad.then(|| format!("{} {}", entry["text"], entry["url"]))
                }
            };
            complaints.extend(complaint);
        }
        complaints
    }

    /// What the page asked for beside itself and `data:` addresses, since the last time.
    pub(crate) fn requests(&self) -> Vec<String> {
        let events = self.chromium.events(&self.session, &["Network.requestWillBeSent"]);
        let urls = events.iter().filter(|event| event["params"]["type"] != "Document");
        let urls =
            urls.map(|event| event["params"]["request"]["url"].as_str().unwrap_or_default().to_owned());
        urls.filter(|url| !url.starts_with("data:")).collect()
    }
}

impl Drop for Tab {
    fn drop(&mut self) {
        // after a failure the browser may be the reason: asking it anything could fail again
        if !thread::panicking() {
            self.chromium.call(None, "Target.closeTarget", &json!({ "targetId": self.target }));
            let context = json!({ "browserContextId": self.context });
            self.chromium.call(None, "Target.disposeBrowserContext", &context);
        }
        self.chromium.forget(&self.session);
    }
}

/// A part of the page as a screen reader has it.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Spoken {
    pub(crate) role: String,
    pub(crate) name: String,
    /// Of a heading.
    pub(crate) level: Option<u64>,
}

fn description(thrown: &Value) -> String {
    let described = thrown["exception"]["description"].as_str();
    described.or(thrown["text"].as_str()).unwrap_or("an exception without a text").to_owned()
}

fn from_base64(text: &str) -> Vec<u8> {
    let value = |byte: u8| match byte {
        b'A'..=b'Z' => byte - b'A',
        b'a'..=b'z' => byte - b'a' + 26,
        b'0'..=b'9' => byte - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => panic!("`{}` in base64", byte.escape_ascii()),
    };
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    for group in text.trim_end_matches('=').as_bytes().chunks(4) {
        let bits = group.iter().fold(0, |bits, byte| bits << 6 | u32::from(value(*byte)));
        let bits = bits << (6 * (4 - group.len()));
        bytes.extend(&bits.to_be_bytes()[1..group.len()]);
    }
    bytes
}
