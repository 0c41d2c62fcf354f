(* The pieces of an operand, the hulls of their groups, and points of covered cells, for the proved
   checker. Not trusted: where it is wrong, the checker says no. *)

open Failure
open Json
open Rings

let hull points =
  let sorted = List.sort_uniq compare_points points in
  let chain run =
    let rec add p = function
      | b :: a :: rest when turn a b p <= 0 -> add p (a :: rest)
      | found -> p :: found
    in
    match List.fold_left (fun found p -> add p found) [] run with
    | _ :: rest -> List.rev rest
    | [] -> []
  in
  match sorted with [ _ ] -> sorted | _ -> chain sorted @ chain (List.rev sorted)

(* What a convex body has on the left of lines *)
let clipped body lines =
  let clip body (u, v) =
    let side p = cross (v -- u) (p -- u) in
    List.concat_map
      (fun (p, q) ->
        let a = side p and b = side q in
        let kept = if Q.sign a >= 0 then [ p ] else [] in
        if Q.sign a * Q.sign b < 0 then
          let t = Q.div a (Q.sub a b) in
          kept @ [ p ++ times t (q -- p) ]
        else kept)
      (edges_of body)
  in
  List.fold_left clip body lines

(* Corners in doubles, which propose: what they leave open is decided exactly. *)
type body = { corners : point list; rough : (float * float) array }

let rough (x, y) = (Q.to_float x, Q.to_float y)
let body corners = { corners; rough = Array.of_list (List.map rough corners) }

(* How far inside a convex polygon a point is, about; no number where doubles do not tell corners
   apart *)
let depth polygon (x, y) =
  let n = Array.length polygon in
  let least = ref max_float in
  for i = 0 to n - 1 do
    let a, b = polygon.(i) and c, d = polygon.(if i + 1 = n then 0 else i + 1) in
    let u = c -. a and v = d -. b in
    let side = ((u *. (y -. b)) -. (v *. (x -. a))) /. Float.hypot u v in
    if Float.is_nan side || side < !least then least := side
  done;
  !least

let is_inside polygon p =
  List.for_all (fun (u, v) -> Q.sign (cross (v -- u) (p -- u)) >= 0) (edges_of polygon)

(* A point p of a with x - p in b: a corner of one, if one will do; else by cutting *)
let part_at x a b =
  let by_cutting () =
    let mirrored = List.map (fun p -> x -- p) in
    let found =
      if List.length b.corners > 2 then clipped a.corners (edges_of (mirrored b.corners))
      else clipped (mirrored b.corners) (edges_of a.corners)
    in
    match found with p :: _ -> p | [] -> fail Refuted "a covered cell has a corner outside"
  in
  if Array.length a.rough < 3 || Array.length b.rough < 3 then by_cutting ()
  else begin
    let x', y' = rough x in
    let best = ref neg_infinity and choice = ref (-1) and of_a = ref true in
    let try_corners corners other own =
      Array.iteri
        (fun i (u, v) ->
          let found = depth other (x' -. u, y' -. v) in
          if found > !best then (best := found; choice := i; of_a := own))
        corners
    in
    try_corners a.rough b.rough true;
    if !best <= 0. then try_corners b.rough a.rough false;
    if !choice < 0 then by_cutting ()
    else begin
      let size = Array.fold_left (fun m (u, v) -> Float.max m (Float.abs u +. Float.abs v)) 1. in
      let doubt = 1e-9 *. (Float.abs x' +. Float.abs y' +. size a.rough +. size b.rough) in
      let p = if !of_a then List.nth a.corners !choice else x -- List.nth b.corners !choice in
      let certain () =
        if !of_a then is_inside b.corners (x -- p) else is_inside a.corners p
      in
      if !best > doubt || (!best > -.doubt && certain ()) then p else by_cutting ()
    end
  end

(* Step `pieces`: its nodes, not scaled *)
type pieces = {
  operand : Reading.operand;
  hulls : point list array;  (* corners only *)
  children : int list array;  (* none of a piece *)
}

let pieces_step operand_of budget step =
  match members step [ "rule"; "of"; "pieces"; "groups" ] with
  | [ _; of_; pieces; groups ] ->
    let operand : Reading.operand = operand_of (text of_) in
    let vertices = operand.vertices in
    let corner value = vertices.(index value (Array.length vertices)) in
    let pieces = List.map (fun piece -> List.map corner (items piece)) (items pieces) in
    budget (List.length (List.concat pieces));
    let count = List.length pieces in
    let groups = Array.of_list (List.map items (items groups)) in
    let hulls = Array.make (count + Array.length groups) []
    and children = Array.make (count + Array.length groups) [] in
    List.iteri (fun i piece -> hulls.(i) <- straightened piece) pieces;
    Array.iteri
      (fun i group ->
        let own = count + i in
        children.(own) <- List.map (fun value -> index value own) group;
        let corners = List.concat_map (fun child -> hulls.(child)) children.(own) in
        require (corners <> []) "a group has no member";
        budget (List.length corners);
        hulls.(own) <- hull corners)
      groups;
    { operand; hulls; children }
  | _ -> assert false

(* A vertex for the checker, at each factor; where they are the same it does not move. *)
let scaled factors v =
  match factors with
  | s :: rest when List.for_all (Q.equal s) rest -> Checked.corner [ times s v ]
  | _ -> Checked.corner (List.map (fun s -> times s v) factors)

(* The tree of the last node, and which leaf of it each piece is; of a group -1. The proof wants
   each piece once; and where nodes are in two groups the tree could be as large as 2^n. *)
let tree pieces budget factors =
  let place = Hashtbl.create 64 and count = ref 0 in
  let scaled = List.map (scaled factors) in
  let rec node n =
    budget 1;
    if Hashtbl.mem place n then fail Declined "a node is in two groups: this is not followed";
    let is_piece = pieces.children.(n) = [] in
    Hashtbl.add place n (if is_piece then !count else -1);
    if is_piece then begin
      incr count;
      Checked.piece (scaled pieces.hulls.(n))
    end
    else Checked.group (scaled pieces.hulls.(n)) (List.map node pieces.children.(n))
  in
  let count = Array.length pieces.hulls in
  let root = if count = 0 then Checked.piece [] else node (count - 1) in
  (root, place)

(* The pieces below a node, as leaves of the tree *)
let rec leaves pieces budget place n =
  budget 1;
  if not (Hashtbl.mem place n) then fail Declined "a solid is not below the last node";
  match pieces.children.(n) with
  | [] -> [ Hashtbl.find place n ]
  | children -> List.concat_map (leaves pieces budget place) children

(* An operand by a factor, or by two between which it moves. Solids get their numbers when they are
   first used. *)
type side = {
  pieces : pieces;
  factors : Q.t list;
  root : Checked.node;
  place : (int, int) Hashtbl.t;
  bodies : (int, int * body list) Hashtbl.t;  (* a body for each factor *)
  mutable solids : (Checked.corner list * int list) list;  (* the last first *)
}

let side pieces budget factors =
  let stays = List.exists (fun (u, v) -> compare_points u v = 0) in
  let { Reading.polygons; _ } = pieces.operand in
  if (not (Reading.is_thin pieces.operand))
     && List.exists (fun ring -> stays (edges_of ring)) (Reading.rings_of polygons)
  then fail Declined "a ring has a vertex twice in a row: this is not followed";
  if polygons <> [] && Array.length pieces.hulls = 0 then
    fail Declined "rings that cancel are the empty set: this is not followed";
  let root, place = tree pieces budget factors in
  Array.iteri
    (fun n children ->
      demand (children <> [] || Hashtbl.mem place n) "the last node does not hold all pieces")
    pieces.children;
  { pieces; factors; root; place; bodies = Hashtbl.create 64; solids = [] }

let solid budget side n =
  match Hashtbl.find_opt side.bodies n with
  | Some found -> found
  | None ->
    let hull = side.pieces.hulls.(n) in
    let bodies = List.map (fun s -> body (List.map (times s) hull)) side.factors in
    let found = (Hashtbl.length side.bodies, bodies) in
    Hashtbl.add side.bodies n found;
    let corners = List.map (scaled side.factors) hull in
    side.solids <- (corners, leaves side.pieces budget side.place n) :: side.solids;
    found

(* A point p of a solid at each factor, with x - p in another one: any two ends will do *)
let part (x : places) first second : places =
  List.map2 (fun x (a, b) -> part_at x a b) x (List.combine first second)

let tiled side = Checked.tiled side.root (List.rev side.solids)
