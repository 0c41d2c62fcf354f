(* What moves between two scales, and what changes at one, for the proved checker. Not trusted. *)

open Failure
open Rings

(* Points that come again, as often as they do *)
let again compare points =
  let rec go found = function
    | a :: (b :: _ as rest) -> go (if compare a b = 0 then a :: found else found) rest
    | _ -> found
  in
  go [] (List.sort compare points)

let as_polygon ring = function
  | outer :: holes -> ({ outer = ring outer; holes = List.map ring holes } : _ Reading.polygon)
  | [] -> invalid_arg "as_polygon"

let state vertex compare (region : Elaborate.region) enclosed : _ Checked.state =
  let ring r = List.map vertex r.turns in
  let passed = List.concat_map (fun r -> r.along) (List.concat region.form) in
  {
    polygons = List.map (as_polygon ring) region.form;
    touching = again compare (List.map vertex passed);
    enclosed;
  }

(* The sum at a scale *)
let there (region : Elaborate.region) enclosed =
  state (fun id -> List.hd (region.place id)) compare_points region enclosed

(* The moving form of a `move` *)
let figure (region : Elaborate.region) enclosed =
  let mover id = Elaborate.mover region.scales (region.place id) in
  state mover Reading.compare_movers region enclosed

let at s (m : Reading.mover) : point = (Q.add m.x0 (Q.mul s m.x1), Q.add m.y0 (Q.mul s m.y1))

(* The rings of a sum between two moves, in the order of the moving form, each from the vertex that
   it has first there *)
let arranged (region : Elaborate.region) s (polygons : Reading.mover Reading.polygon list) =
  let point id = List.hd (region.place id) in
  let known = Hashtbl.create 64 in
  let key (x, y) = (Q.to_string x, Q.to_string y) in
  List.iter
    (List.iter (fun ring -> Hashtbl.add known (key (point (List.hd ring.turns))) ring))
    region.form;
  let is_same p id = compare_points p (point id) = 0 in
  let ring movers =
    let points = List.map (at s) movers in
    let first = least compare_points points in
    let candidates =
      Hashtbl.find_all known (key first)
      |> List.map (fun ring ->
             let turns = from (is_same (List.hd points)) ring.turns in
             started (List.hd turns) ring)
    in
    let fits ring =
      List.compare_lengths ring.turns points = 0 && List.for_all2 is_same points ring.turns
    in
    match List.find_opt fits candidates with
    | Some found -> found
    | None -> fail Refuted ("the boundary changes at " ^ Q.to_string s)
  in
  let polygon (p : _ Reading.polygon) = List.map ring (p.outer :: p.holes) in
  let found = List.map polygon polygons in
  let count form = List.length (List.concat form) in
  demand
    (count found = count region.form)
    ("the boundary changes at " ^ Q.to_string s);
  found

(* Of a `move`, and then in turn an `eq` and a `move`, from end to end: the moving form and the
   derivations *)
let interval from upto (regions : Elaborate.region list) enclosed =
  let apart () = fail Refuted "the steps do not reach end to end" in
  let meet a b = if not (Q.equal a b) then apart () in
  let derivation (region : Elaborate.region) = region.derivation region.form in
  match regions with
  | [] -> fail Malformed "an interval has no step"
  | first :: rest ->
    let figure =
      match first.scales with [ a; _ ] -> meet a from; figure first enclosed | _ -> apart ()
    in
    let rec go before = function
      | [] -> meet before upto; []
      | (there : Elaborate.region) :: next :: more -> (
        match (there.scales, next.scales) with
        | [ s ], [ a; b ] ->
          meet before s;
          meet a s;
          let arranged = there.derivation (arranged there s figure.polygons) in
          (s, arranged, derivation next) :: go b more
        | _ -> apart ())
      | [ _ ] -> apart ()
    in
    let rest = go (List.nth first.scales 1) rest in
    (figure, derivation first, rest)

(* The first entry of two lists that one has more often than the other *)
let differing l k =
  let count list =
    let found = Hashtbl.create 64 in
    let times x = Option.value (Hashtbl.find_opt found x) ~default:0 in
    List.iter (fun x -> Hashtbl.replace found x (times x + 1)) list;
    times
  in
  let in_l = count l and in_k = count k in
  let rec go n = function
    | [] -> None
    | x :: rest -> if in_l x <> in_k x then Some n else go (n + 1) rest
  in
  go 0 (l @ k)

(* Where two figures differ, as the checker counts turns. Vertices are compared by their texts. *)
let difference text (a : _ Checked.state) (b : _ Checked.state) =
  let turns polygons =
    List.concat_map
      (fun ring ->
        let edges = edges_of (List.map text ring) in
        List.map (fun ((u, v), (_, w)) -> (u, v, w)) (edges_of edges))
      (Reading.rings_of polygons)
  in
  match differing (turns a.polygons) (turns b.polygons) with
  | Some n -> Some (Checked.of_turn n)
  | None ->
    Option.map
      Checked.of_touching
      (differing (List.map text a.touching) (List.map text b.touching))

let text_of_mover m = List.map Q.to_string (Reading.numbers_of m)
let text_of_point (x, y) = List.map Q.to_string [ x; y ]

(* What makes the event, if anything does *)
let change is_of_boundary s (before : Reading.mover Checked.state) there after =
  if is_of_boundary then
    match difference text_of_mover before after with
    | Some found -> Some (Checked.another_after found)
    | None ->
      let ring = List.map (at s) in
      let polygon (p : _ Reading.polygon) : _ Reading.polygon =
        { outer = ring p.outer; holes = List.map ring p.holes }
      in
      let here : point Checked.state =
        {
          polygons = List.map polygon before.polygons;
          touching = ring before.touching;
          enclosed = before.enclosed;
        }
      in
      Option.map Checked.another_there (difference text_of_point here there)
  else
    let numbers (m : _ Checked.state) = (List.length m.polygons, m.enclosed) in
    if numbers before = numbers there && numbers there = numbers after then None
    else Some Checked.other_numbers
