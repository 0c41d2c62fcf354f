(* What a case says, and the text that a set is named by. Trusted: the theorem is about the sets
   that are read here. *)

open Failure
open Json

type point = Q.t * Q.t
type 'vertex polygon = { outer : 'vertex list; holes : 'vertex list list }

type operand = { name : string; polygons : point polygon list; vertices : point array }

(* A vertex that moves: at the scale s it is (x0 + s x1, y0 + s y1). *)
type mover = { x0 : Q.t; x1 : Q.t; y0 : Q.t; y1 : Q.t }

(* Scales of a claim about a path: all from one to another, with or without the ends; None for no
   end. 0 never belongs to them. *)
type scales = { low : Q.t; high : Q.t option; low_in : bool; high_in : bool }
type contact = Allowed | Forbidden

let numbers_of m = [ m.x0; m.x1; m.y0; m.y1 ]
let compare_movers m n = List.compare Q.compare (numbers_of m) (numbers_of n)

let rings_of polygons = List.concat_map (fun p -> p.outer :: p.holes) polygons

let point value : point =
  let x, y = pair value in
  (number x, number y)

let mover value =
  match List.map number (items value) with
  | [ x0; x1; y0; y1 ] -> { x0; x1; y0; y1 }
  | _ -> fail Malformed "a place that moves has four numbers"

let scales value =
  match members value [ "from"; "to"; "from_in"; "to_in" ] with
  | [ from; upto; Bool low_in; Bool high_in ] ->
    let low = number from and high = match upto with Null -> None | found -> Some (number found) in
    require (Q.sign low > 0 || (Q.sign low = 0 && not low_in)) "these are no scales";
    (match high with
     | None -> require (not high_in) "these are no scales"
     | Some b ->
       let order = Q.compare low b in
       require (order < 0 || (order = 0 && low_in && high_in)) "these are no scales");
    { low; high; low_in; high_in }
  | _ -> fail Malformed "scales say whether their ends belong to them"

let contact value =
  match value with
  | Text "allowed" -> Allowed
  | Text "forbidden" -> Forbidden
  | _ -> fail Malformed "there is no such contact"

let same ((a, b) : point) ((c, d) : point) = Q.equal a c && Q.equal b d

(* Vertex i of sP plus vertex j of Q, None for none of it *)
let place s ps qs (i, j) : point =
  let at vertices = Option.fold ~none:(Q.zero, Q.zero) ~some:(Array.get vertices) in
  let (a, b), (c, d) = (at ps i, at qs j) in
  Q.((s * a) + c, (s * b) + d)

let doubled_area ring =
  match ring with
  | [] -> Q.zero
  | first :: _ ->
    let rec go sum = function
      | [] -> sum
      | (x, y) :: rest ->
        let u, v = match rest with next :: _ -> next | [] -> first in
        go Q.(sum + ((x * v) - (u * y))) rest
    in
    go Q.zero ring

(* Outer rings run counter-clockwise and holes clockwise. A ring of one or two vertices, a point or
   a segment, is the only one. *)
let operand name value =
  let ring value =
    let found = List.map point (items value) in
    require (found <> []) (name ^ " has an empty ring");
    found
  in
  let polygon value =
    match members value [ "outer"; "holes?" ] with
    | [ outer; holes ] ->
      let outer = ring outer in
      { outer; holes = (match holes with Null -> [] | _ -> List.map ring (items holes)) }
    | _ -> assert false
  in
  let polygons =
    match members value [ "polygons" ] with
    | [ found ] -> List.map polygon (items found)
    | _ -> assert false
  in
  let rings = rings_of polygons in
  let thin = List.exists (fun ring -> List.length ring < 3) rings in
  require ((not thin) || List.length rings = 1) (name ^ " has a ring of too few vertices");
  if not thin then
    List.iter
      (fun p ->
        let wrong = name ^ " has a ring that runs the wrong way" in
        require (Q.sign (doubled_area p.outer) > 0) wrong;
        List.iter (fun hole -> require (Q.sign (doubled_area hole) < 0) wrong) p.holes)
      polygons;
  { name; polygons; vertices = Array.of_list (List.concat rings) }

let is_thin operand =
  match rings_of operand.polygons with [ [ _ ] ] | [ [ _; _ ] ] -> true | _ -> false

(* The JSON of polygons without white space, numbers in lowest terms: what is hashed *)
let text_of numbers polygons =
  let number q = "\"" ^ Q.to_string q ^ "\"" in
  let list write values = "[" ^ String.concat "," (List.map write values) ^ "]" in
  let ring = list (fun vertex -> list number (numbers vertex)) in
  let polygon p = Printf.sprintf "{\"holes\":%s,\"outer\":%s}" (list ring p.holes) (ring p.outer) in
  list polygon polygons

let polygons_text polygons = text_of (fun (x, y) -> [ x; y ]) polygons
let movers_text polygons = text_of numbers_of polygons

let case_digest p q =
  Sha256.hex_digest
    (Printf.sprintf "{\"P\":%s,\"Q\":%s}" (polygons_text p.polygons) (polygons_text q.polygons))

let digest_of text = Sha256.hex_digest (Printf.sprintf "{\"polygons\":%s}" text)

(* The digest that a certificate names: of a verified one, that of its case *)
let digest_named certificate =
  match certificate with
  | Object found -> (
    match List.assoc_opt "case" found with
    | Some case -> text (List.nth (members case [ "path"; "sha256" ]) 1)
    | None -> "")
  | _ -> ""

(* Whether a path stays in the folder that it is read from *)
let is_inside path =
  List.for_all (fun step -> step <> "" && step <> "..") (String.split_on_char '/' path)

(* What carries no truth is text. The path of the case, and its digest *)
let head texts case =
  List.iter
    (function Null | Text _ -> () | _ -> fail Malformed "what carries no truth is no text")
    texts;
  match members case [ "path"; "sha256" ] with
  | [ path; digest ] ->
    let path = text path in
    let last = List.hd (List.rev (String.split_on_char '/' path)) in
    require (not (String.contains path '\000' || last = "" || last = ".")) "no path of a case";
    (path, text digest)
  | _ -> assert false
