//! The loop of an adapter in Rust: requests from standard input, answers to standard output
//! (docs/adapter-protocol.md). An adapter copies this file beside its own at installation.

use serde_json::{Value, json};
use std::io::{BufRead, Write};

pub type Ring = Vec<[f64; 2]>;
pub type Function = fn(&Value) -> Result<Vec<Ring>, String>;

/// Each polygon's rings: the outer one counter-clockwise, its holes clockwise.
pub fn polygons_of(set: &Value) -> Result<Vec<Vec<Ring>>, String> {
    let polygons = set["polygons"].as_array().ok_or("no polygons")?;
    polygons.iter().map(rings_of).collect()
}

fn rings_of(polygon: &Value) -> Result<Vec<Ring>, String> {
    let holes = polygon["holes"].as_array().ok_or("no holes")?;
    std::iter::once(&polygon["outer"]).chain(holes).map(ring_of).collect()
}

fn ring_of(value: &Value) -> Result<Ring, String> {
    let points = value.as_array().ok_or("a ring is no list")?;
    points
        .iter()
        .map(|p| Ok([p[0].as_f64().ok_or("no number")?, p[1].as_f64().ok_or("no number")?]))
        .collect()
}

/// Answers until `stop`. `verbs`: the functions by their verbs; each takes the request.
pub fn serve(hello: Value, verbs: &[(&str, Function)]) {
    let mut answers = std::io::stdout();
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let request: Value = serde_json::from_str(&line).unwrap_or(Value::Null);
        let mut answer = answer(&request, &hello, verbs);
        answer["seq"] = request.get("seq").cloned().unwrap_or(Value::Null);
        writeln!(answers, "{answer}").expect("standard output");
        answers.flush().expect("standard output");
        if request["verb"] == "stop" {
            return;
        }
    }
}

fn answer(request: &Value, hello: &Value, verbs: &[(&str, Function)]) -> Value {
    match request["verb"].as_str() {
        Some("hello") => {
            let mut found = hello.clone();
            found["status"] = json!("result");
            found["protocol"] = json!("adapter-v1");
            found
        }
        Some("load") if request["Q"].is_null() => json!({"status": "errored", "reason": "no Q"}),
        Some("load" | "stop") => json!({"status": "result"}),
        verb => match verbs.iter().find(|(name, _)| Some(*name) == verb) {
            None => json!({"status": "skipped", "reason": "no such verb here"}),
            Some((_, function)) => match function(request) {
                Ok(rings) => json!({"status": "result", "rings": rings}),
                Err(reason) => json!({"status": "errored", "reason": reason}),
            },
        },
    }
}
