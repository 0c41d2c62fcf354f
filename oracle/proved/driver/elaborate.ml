(* From the steps of a certificate to witnesses of the proved checker. Not trusted: it works out the
   points of cells, hulls, and for each corner of a covered cell a point of P that leaves one of Q.
   Where it is wrong, the checker says no. *)

open Failure
open Json
open Rings

let times s (x, y) : point = (Q.mul s x, Q.mul s y)

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
let part x a b =
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

(* The tree of the last node, and which leaf of it each piece is; of a group -1. The proof wants
   each piece once; and where nodes are in two groups the tree could be as large as 2^n. *)
let tree pieces budget s =
  let place = Hashtbl.create 64 and count = ref 0 in
  let scaled = List.map (times s) in
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
let rec leaves pieces place n =
  if not (Hashtbl.mem place n) then fail Declined "a solid is not below the last node";
  match pieces.children.(n) with
  | [] -> [ Hashtbl.find place n ]
  | children -> List.concat_map (leaves pieces place) children

(* Solids get their numbers when they are first used. *)
type side = {
  pieces : pieces;
  factor : Q.t;
  root : Checked.node;
  place : (int, int) Hashtbl.t;
  bodies : (int, int * body) Hashtbl.t;
  mutable solids : (point list * int list) list;  (* the last first *)
}

let side pieces budget factor =
  let root, place = tree pieces budget factor in
  { pieces; factor; root; place; bodies = Hashtbl.create 64; solids = [] }

let solid side n =
  match Hashtbl.find_opt side.bodies n with
  | Some found -> found
  | None ->
    let corners = List.map (times side.factor) side.pieces.hulls.(n) in
    let found = (Hashtbl.length side.bodies, body corners) in
    Hashtbl.add side.bodies n found;
    side.solids <- (corners, leaves side.pieces side.place n) :: side.solids;
    found

let tiled side = Checked.tiled side.root (List.rev side.solids)

(* Elements: a line is the points z with normal * z = offset. *)
type element = Line of point * Q.t | Point of point

let element elements count p q s value =
  match items value with
  | [] -> fail Malformed "an element is empty"
  | kind :: entry -> (
    let known i = elements.(index i count) in
    let line i = match known i with Line (n, c) -> (n, c) | _ -> fail Malformed "no line to meet" in
    let through (mover : Reading.operand) (other : Reading.operand) factor back i k j =
      let at (o : Reading.operand) i = o.vertices.(index i (Array.length o.vertices)) in
      let a = times factor (at mover i) and b = times factor (at mover k) in
      let by = times back (at other j) in
      demand (compare_points a b <> 0) "a line has no direction";
      let dx, dy = b -- a in
      let n = (Q.neg dy, dx) in
      let x, y = a ++ by in
      Line (n, Q.((fst n * x) + (snd n * y)))
    in
    match (text kind, entry) with
    | "P", [ i; k; j ] -> through p q s Q.one i k j
    | "Q", [ i; k; j ] -> through q p Q.one s i k j
    | "meet", [ a; b ] ->
      let (n, c), (m, d) = (line a, line b) in
      let w = cross n m in
      demand (Q.sign w <> 0) "parallel lines do not meet";
      Point
        ( Q.(((c * snd m) - (d * snd n)) / w),
          Q.(((fst n * d) - (fst m * c)) / w) )
    | "up", [ a ] -> (
      match known a with
      | Point (x, _) -> Line ((Q.one, Q.zero), x)
      | Line _ -> fail Malformed "a line is up of no point")
    | _ -> fail Malformed "there is no such element")

(* Step `eq`: the witness, and the rings in canonical form *)
type region = {
  scale : Q.t;
  witness : Checked.witness;
  components : Checker.component list;
  outside : Checker.component;
  holes : Checker.component list;
  polygons : Reading.polygon list;
  stretches : Checked.stretch list list list list;
  point : Json.value -> int * point;  (* a point of the step, with its number *)
  contacts : (int list, Checked.token list) Hashtbl.t;
  beside : int * int -> int * int;
}

let names =
  [ "rule"; "scales"; "by"; "box"; "elements"; "cells"; "normals"; "proofs"; "contacts";
    "polygons" ]

let eq_step p q (by_p, by_q) budget step =
  match members step names with
  | [ _; scales; _; box; elements; cells; normals; proofs; contacts; polygons ] ->
    let s =
      match items scales with [ s ] -> number s | _ -> fail Malformed "one scale is missing"
    in
    require (Q.sign s > 0) "a scale is not positive";
    let of_p = side by_p budget s and of_q = side by_q budget Q.one in
    let x0, y0, x1, y1 =
      match List.map number (items box) with
      | [ a; b; c; d ] -> (a, b, c, d)
      | _ -> fail Malformed "a box has four walls"
    in
    let given = items elements in
    let found = Array.make (4 + List.length given) (Line ((Q.one, Q.zero), x0)) in
    found.(1) <- Line ((Q.zero, Q.one), y0);
    found.(2) <- Line ((Q.one, Q.zero), x1);
    found.(3) <- Line ((Q.zero, Q.one), y1);
    List.iteri
      (fun i value ->
        budget 1;
        found.(4 + i) <- element found (4 + i) p q s value)
      given;
    let corner value =
      match found.(index value (Array.length found)) with
      | Point at -> at
      | Line _ -> fail Malformed "a corner is no point"
    in
    let normals = Array.of_list (List.map Reading.point (items normals)) in
    let tokens corners code =
      let token value =
        budget (List.length corners);
        let n = integer value in
        if Z.equal n (Z.of_int (-1)) then Checked.open_p
        else if Z.equal n (Z.of_int (-2)) then Checked.open_q
        else Checked.normal normals.(index value (Array.length normals))
      in
      List.map token code
    in
    let cell value proof =
      let corners = straightened (List.map corner (items value)) in
      budget (List.length corners);
      match items proof with
      | Text "cov" :: [ a; b ] ->
        let node side value = index value (Array.length side.pieces.hulls) in
        let i, first = solid of_p (node of_p a) and j, second = solid of_q (node of_q b) in
        let parts =
          List.map
            (fun x ->
              budget (Array.length first.rough + Array.length second.rough);
              part x first second)
            corners
        in
        Checked.covered corners i j parts
      | Text "sep" :: code -> Checked.apart corners (tokens corners code)
      | _ -> fail Malformed "a cell has no proof"
    in
    let cells = items cells and proofs = items proofs in
    require (List.compare_lengths cells proofs = 0) "there are not as many proofs as cells";
    let ids value = List.map (fun v -> index v (Array.length found)) (items value) in
    let is_covered proof = match items proof with Text "cov" :: _ -> true | _ -> false in
    let point id =
      match found.(id) with Point at -> at | Line _ -> fail Malformed "a corner is no point"
    in
    let form =
      in_order point (List.map (fun polygon -> List.map ids (items polygon)) (items polygons))
    in
    let classes = Classes.found (List.map ids cells) (List.map is_covered proofs) form point in
    let made = Array.of_list (List.map2 cell cells proofs) in
    let cells = List.map (fun i -> made.(i)) classes.order in
    let polygon rings : Reading.polygon =
      match List.map (fun ring -> ring.vertices) rings with
      | outer :: holes -> { outer; holes }
      | [] -> assert false
    in
    let polygons = List.map polygon form in
    let box = [ (x0, y0); (x1, y0); (x1, y1); (x0, y1) ] in
    let witness = Checked.witness (tiled of_p) (tiled of_q) box cells in
    let empty side = Array.length side.pieces.hulls = 0 in
    let of_no_empty_sum classes = if empty of_p || empty of_q then [] else classes in
    let components = of_no_empty_sum classes.components in
    let holes = of_no_empty_sum classes.holes in
    let outside = classes.outside and stretches = classes.stretches and beside = classes.beside in
    let touching = Hashtbl.create 16 in
    List.iter
      (fun contact ->
        match items contact with
        | value :: code ->
          let numbers = ids value in
          Hashtbl.replace touching numbers (tokens (List.map point numbers) code)
        | [] -> fail Malformed "a contact is empty")
      (items contacts);
    let point value =
      let n = index value (Array.length found) in
      (n, point n)
    in
    {
      scale = s; witness; components; outside; holes; polygons; stretches; point;
      contacts = touching; beside;
    }
  | _ -> assert false

(* The contacts of a path, for the proved checker *)
let contacts region path =
  let rec segments = function
    | a :: (b :: _ as rest) -> [ a; b ] :: segments rest
    | _ -> []
  in
  List.map
    (fun numbers ->
      match Hashtbl.find_opt region.contacts numbers with
      | None -> fail Refuted "this is no contact"
      | Some code ->
        let left, right = match numbers with [ u; v ] -> region.beside (u, v) | _ -> (0, 0) in
        Checked.contact code left right)
    (match path with [ _ ] -> [ path ] | _ -> segments path)
