(* Questions without a certificate: which points are in a sum, what the sum is, and what sets are
   together. Trusted: what is answered is what [Checked] was asked, of the sets that [Reading]
   found. *)

open Failure
open Json

type question = {
  p : Reading.operand;
  q : Reading.operand;
  scale : Q.t;
  points : Reading.point list;
}

let question text =
  match members (parse ~decimals:true text) [ "P"; "Q"; "scale"; "points?" ] with
  | [ p; q; scale; points ] ->
    let p = Reading.operand "P" p and q = Reading.operand "Q" q in
    let p, scale =
      match scale with
      | List _ -> (fst (Claims.scaled_by scale p), Q.one)
      | _ -> (p, Intervals.scale_of scale)
    in
    let points = match points with Null -> [] | _ -> List.map Reading.point (items points) in
    { p; q; scale; points }
  | _ -> assert false

(* As many as there are pairs of edges, for each of so many *)
let spend budget { p; q; _ } count =
  let n = Array.length p.vertices and m = Array.length q.vertices in
  budget ((count * (1 + (n * m))) + (n * n) + (m * m))

(* A question without an answer; the theorems say why there is none. *)
let answered { p; q; _ } answer =
  let legal (o : Reading.operand) = Checked.is_legal o.polygons in
  match answer with
  | Some found -> found
  | None ->
    require (legal p && legal q) "P or Q is not legal: rings cross, overlap or wind twice";
    if Reading.is_thin p && Reading.is_thin q then
      fail Declined "there is no theorem about sums of two points or segments";
    (* not reached, by [decided_points_are_right] and [verified_sum_is_complete] *)
    assert false

(* Each point, and whether it is in the sum, by the program that is proved right *)
let points asked budget =
  require (asked.points <> []) "no point is asked about";
  spend budget asked (List.length asked.points);
  let { p; q; scale; points } = asked in
  let found = Checked.decide_points scale p.polygons q.polygons points in
  List.combine points (answered asked found)

(* The sum: what is answered is proved to be right *)
let sum asked budget =
  require (asked.points = []) "points are asked about, not the sum";
  spend budget asked 1;
  let { p; q; scale; _ } = asked in
  answered asked (Checked.verified_sum scale p.polygons q.polygons)

let operation_named = function
  | Text "union" -> Checked.Unite
  | Text "intersection" -> Checked.Intersect
  | Text "difference" -> Checked.Subtract
  | _ -> fail Malformed "the operation is none of union, intersection, difference"

let combining text =
  match members (parse ~decimals:true text) [ "operation"; "sets" ] with
  | [ operation; sets ] ->
    let operand i = Reading.operand (Printf.sprintf "set %d" i) in
    (operation_named operation, List.mapi operand (items sets))
  | _ -> assert false

(* A set and others combined: what is answered is proved to be right *)
let combination (operation, sets) budget =
  let polygons (o : Reading.operand) = o.polygons in
  match sets with
  | [] -> fail Malformed "there is no set"
  | first :: others -> (
    let n = List.fold_left (fun n (o : Reading.operand) -> n + Array.length o.vertices) 0 sets in
    budget (1 + (n * n));
    match Checked.verified_combination operation (polygons first) (List.map polygons others) with
    | Some found -> found
    | None ->
      let wrong (o : Reading.operand) = not (Checked.is_polygon_set o.polygons) in
      let { Reading.name; _ } = List.find wrong sets in
      fail Malformed
        (name ^ " is no legal polygon set: rings cross, overlap or wind twice, or it has no area"))

let quoted_number q = Text.quoted (Q.to_string q)

(* The answers as the members of a line of JSON, and in words *)
let points_json found =
  let one ((x, y), is_in) =
    Printf.sprintf "{\"point\": [%s, %s], \"in_sum\": %b}" (quoted_number x) (quoted_number y) is_in
  in
  Printf.sprintf "\"points\": [%s]" (String.concat ", " (List.map one found))

let points_said =
  List.map (fun (x, is_in) ->
      Claims.shown_point x ^ if is_in then " is in the sum" else " is not in the sum")

let digest polygons = Reading.digest_of (Reading.polygons_text polygons)

let set_json (polygons, holes) =
  Printf.sprintf "\"components\": %d, \"holes\": %d, \"digest\": %s, \"polygons\": %s"
    (List.length polygons) holes
    (Text.quoted (digest polygons))
    (Reading.polygons_text polygons)

let set_said (polygons, holes) =
  [ Printf.sprintf "%d components and %d holes, of digest %s" (List.length polygons) holes
      (digest polygons) ]
