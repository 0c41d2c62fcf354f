(* From the steps `eq` and `move` of a certificate to what the proved checker is given. Not trusted:
   it works out the points of cells, at both ends of a `move`. Where it is wrong, the checker says
   no. *)

open Failure
open Json
open Rings
open Pieces

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

(* What a step says of the sum: its rings in canonical form, and what proves it, with polygons and
   rings in this order or another one. *)
type region = {
  scales : Q.t list;
  form : Rings.ring list list;
  place : int -> places;  (* a point of the step, by its number *)
  point : Json.value -> int * places;
  derivation : Rings.ring list list -> Checked.derivation;
  contacts : (int list, Checked.token list) Hashtbl.t;
  beside : int * int -> int * int;
}

let names =
  [ "rule"; "scales"; "by"; "box"; "elements"; "cells"; "normals"; "proofs"; "contacts";
    "polygons" ]

(* A vertex as it moves between the ends of a step: (x0 + s x1, y0 + s y1) *)
let mover scales places : Reading.mover =
  match (scales, places) with
  | [ a; b ], [ p; q ] ->
    let x1, y1 = times (Q.inv (Q.sub b a)) (q -- p) in
    let x0, y0 = p -- times a (x1, y1) in
    { x0; x1; y0; y1 }
  | _, [ (x0, y0) ] -> { x0; x1 = Q.zero; y0; y1 = Q.zero }
  | _ -> invalid_arg "mover"

(* Whole numbers, not both 0 *)
let normal value =
  let ((x, y) as found) = Reading.point value in
  let is_whole q = Z.equal (Q.den q) Z.one in
  require (is_whole x && is_whole y) "a normal is not of whole numbers";
  require (Q.sign x <> 0 || Q.sign y <> 0) "a normal is zero";
  found

(* An entry of a code of `sep` *)
let token normals value =
  let n = integer value in
  if Z.equal n (Z.of_int (-1)) then Checked.open_p
  else if Z.equal n (Z.of_int (-2)) then Checked.open_q
  else Checked.normal normals.(index value (Array.length normals))

let walls box =
  match List.map number (items box) with
  | [ a; b; c; d ] ->
    demand (Q.lt a c && Q.lt b d) "the box is empty";
    (a, b, c, d)
  | _ -> fail Malformed "a box has four walls"

(* All elements of a step at one of its scales *)
let elements_at p q budget box given s =
  let x0, y0, x1, y1 = box in
  let found = Array.make (4 + List.length given) (Line ((Q.one, Q.zero), x0)) in
  found.(1) <- Line ((Q.zero, Q.one), y0);
  found.(2) <- Line ((Q.one, Q.zero), x1);
  found.(3) <- Line ((Q.zero, Q.one), y1);
  List.iteri
    (fun i value ->
      budget 1;
      found.(4 + i) <- element found (4 + i) p q s value)
    given;
  found

let region p q (by_p, by_q) budget step =
  match members step names with
  | [ rule; scales; _; box; elements; cells; normals; proofs; contacts; polygons ] ->
    let scales = List.map number (items scales) in
    require (List.for_all (fun s -> Q.sign s > 0) scales) "a scale is not positive";
    (match (text rule, scales) with
     | "eq", [ _ ] -> ()
     | "move", [ a; b ] -> require (Q.compare a b < 0) "the scales do not ascend"
     | _ -> fail Malformed "a scale is missing, or there is one more");
    let of_p = side by_p budget scales
    and of_q = side by_q budget (List.map (fun _ -> Q.one) scales) in
    let ((x0, y0, x1, y1) as box) = walls box in
    let ends = List.map (elements_at p q budget box (items elements)) scales in
    let count = Array.length (List.hd ends) in
    let places =
      Array.init count (fun i ->
          List.filter_map (fun found -> match found.(i) with Point at -> Some at | _ -> None) ends)
    in
    let corners = Array.map (function [] -> Checked.origin | at -> Checked.corner at) places in
    let middles = Array.map (function [] -> (Q.zero, Q.zero) | at -> Rings.middle at) places in
    let place id =
      match places.(id) with [] -> fail Malformed "a corner is no point" | found -> found
    in
    let number_of value =
      let id = index value count in
      ignore (place id);
      id
    in
    let ids value = List.map number_of (items value) in
    let corner id = corners.(id) and where id = middles.(id) in
    let half = Q.of_ints 1 2 in
    let middle u v =
      Checked.corner (List.map2 (fun p q -> times half (p ++ q)) (place u) (place v))
    in
    let normals = Array.of_list (List.map normal (items normals)) in
    let tokens corners code =
      let cost = List.length corners * List.length scales in
      List.map (fun value -> budget cost; token normals value) code
    in
    let cell ids proof =
      let turns = turning where ids in
      budget (List.length turns);
      let corners = List.map corner turns in
      match items proof with
      | Text "cov" :: [ a; b ] ->
        let node side value = index value (Array.length side.pieces.hulls) in
        let i, first = solid budget of_p (node of_p a)
        and j, second = solid budget of_q (node of_q b) in
        let cost bodies = List.fold_left (fun n b -> n + Array.length b.rough) 0 bodies in
        let parts =
          List.map
            (fun id ->
              budget (cost first + cost second);
              Checked.corner (part (place id) first second))
            turns
        in
        Checked.covered corners i j parts
      | Text "sep" :: code -> Checked.apart corners (tokens turns code)
      | _ -> fail Malformed "a cell has no proof"
    in
    let cells = List.map ids (items cells) and proofs = items proofs in
    require (List.compare_lengths cells proofs = 0) "there are not as many proofs as cells";
    let made = Array.of_list (List.map2 cell cells proofs) in
    let is_covered =
      List.map (fun proof -> match items proof with Text "cov" :: _ -> true | _ -> false) proofs
    in
    let compare =
      let movers = Array.map (fun at -> lazy (mover scales at)) places in
      fun u v -> Reading.compare_movers (Lazy.force movers.(u)) (Lazy.force movers.(v))
    in
    let given = List.map (fun polygon -> List.map ids (items polygon)) (items polygons) in
    let form = in_order where compare given in
    let tiled_p = tiled of_p and tiled_q = tiled of_q in
    let box =
      List.map
        (fun v -> Checked.corner (List.map (fun _ -> v) scales))
        [ (x0, y0); (x1, y0); (x1, y1); (x0, y1) ]
    in
    let empty side = Array.length side.pieces.hulls = 0 in
    let of_no_empty_sum classes = if empty of_p || empty of_q then [] else classes in
    let found form = Classes.found cells is_covered form corner middle in
    let classes = lazy (found form) in
    let derivation other =
      let found = if other == form then Lazy.force classes else found other in
      let cells = List.map (fun i -> made.(i)) found.order in
      Checked.derivation
        (Checked.witness tiled_p tiled_q box cells)
        (of_no_empty_sum found.components) found.outside (of_no_empty_sum found.holes) found.rows
    in
    let is_missed corners code =
      if empty of_p || empty of_q then code = [] else Checked.is_apart corners code tiled_p tiled_q
    in
    let touching = Hashtbl.create 16 in
    List.iter
      (fun contact ->
        match items contact with
        | value :: code ->
          let numbers = ids value in
          require
            (match numbers with [ _ ] -> true | [ u; v ] -> u <> v | _ -> false)
            "this is no point or segment";
          let code = tokens numbers code in
          demand (is_missed (List.map corner numbers) code) "this is no contact";
          Hashtbl.replace touching numbers code
        | [] -> fail Malformed "a contact is empty")
      (items contacts);
    let point value =
      let n = index value count in
      (n, place n)
    in
    let beside edge = (Lazy.force classes).beside edge in
    { scales; form; place; point; derivation; contacts = touching; beside }
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
