//! iOverlay: `overlay` of one set after the other, and `outline` with round joins, each with the
//! integer engine i64. The argument is union or outline. geo's `buffer` calls `outline` too.
//!
//! The library chooses a grid for each call, as fine as 62 bits allow; doubles have fewer bits, so
//! 1e-9 is generous. Arcs have steps of 0.01 pi, its least: they miss 0.0002 of the radius; its
//! README lets CORDIC rotation move vertices of arcs, without a bound: 0.005 of the radius.

mod adapter_protocol;

use adapter_protocol::{Ring, polygons_of, serve};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use i_overlay::mesh::float::outline::offset::OutlineOffset;
use i_overlay::mesh::float::style::{LineJoin, OutlineStyle};
use serde_json::{Value, json};

fn union_of(request: &Value) -> Result<Vec<Ring>, String> {
    let sets = request["sets"].as_array().ok_or("no sets")?;
    let mut found: Vec<Vec<Ring>> = Vec::new();
    for set in sets {
        let next = polygons_of(set)?;
        found = found.overlay_as::<i64>(&next, OverlayRule::Union, FillRule::NonZero);
    }
    Ok(found.into_iter().flatten().collect())
}

fn offset_of(request: &Value) -> Result<Vec<Ring>, String> {
    let polygons = polygons_of(&request["P"])?;
    let radius = request["radius"].as_f64().ok_or("no radius")?;
    let style = OutlineStyle::new(radius).line_join(LineJoin::Round(0.01 * std::f64::consts::PI));
    Ok(polygons.outline_as::<i64>(&style).into_iter().flatten().collect())
}

fn main() {
    let outline = std::env::args().nth(1).as_deref() == Some("outline");
    let mut hello = json!({
        "name": if outline { "i-overlay-outline" } else { "i-overlay" },
        "version": "9.1.0",
        "language": "Rust",
        "arithmetic": "integer-grid",
        "numbers": "double",
        "tolerance": {"absolute": "0", "relative": "1e-9"},
        "sum": "none",
        "capabilities": ["plane", "non-convex", "holes", "components", "touching", "empty"],
    });
    let verbs: &[&str] = if outline { &["offset", "inset"] } else { &["union"] };
    let able = hello["capabilities"].as_array_mut().expect("a list");
    able.extend(verbs.iter().map(|verb| json!(verb)));
    if outline {
        hello["tolerance"]["radius"] = json!("0.005");
        serve(hello, &[("offset", offset_of)]);
    } else {
        serve(hello, &[("union", union_of)]);
    }
}
