(* A sum as a theorem in Coq: first the statement in the notions of Definitions.v and Form.v, with
   its numbers, then the proof, which has Coq's kernel compute [check_form]. Nothing here is
   trusted: the statement is there to be read (docs/proved.md). *)

let head =
  {|(** The Minkowski sum sP + Q of two sets of the plane, its components, holes and
    canonical form, as a theorem.

    The sets are given by their rings: outer ones counter-clockwise, holes clockwise. What the
    statement means stands in Definitions.v and Form.v of oracle/proved. How to check it, if it
    comes from somebody else: docs/proved.md *)
From Proved Require Import Definitions Form.
Open Scope Q_scope.

Theorem this_is_the_sum :
  let s := |}

let statement components holes =
  Printf.sprintf
    {|  (forall x : point, set_of (rings_of (figure R')) x <->
    exists p q, set_of (points P) p /\ set_of (points Q') q /\ x = add (scale (Q2R s) p) q) /\
  has_components (set_of (rings_of (figure R'))) %d /\
  has_holes (set_of (rings_of (figure R'))) %d /\
  is_canonical (set_of (rings_of (figure R'))) (figure R').
|}
    components holes

let proof =
  {|Proof. (* Nothing is believed of what follows. *)
From Proved Require Import Numbers Checker Figures Canonical.
intros s P Q' R'.
|}

let foot =
  {|exact (form_is_right s P Q' R' everything
  (eq_refl true <: check_form s P Q' R' everything = true)).
Qed.
Print Assumptions this_is_the_sum.
|}

(* What writes the terms of a theorem *)
type terms = {
  list : 'a. string -> ('a -> unit) -> 'a list -> unit;
  number : Q.t -> unit;
  given : Q.t * Q.t -> unit;
  rings : string -> (Q.t * Q.t) list list -> unit;
  vertex : Checker.corner -> unit;
  corners : Checker.corner list -> unit;
  tiled : string -> Checker.tiled -> unit;
  token : Checker.token -> unit;
}

let natural out i = Printf.fprintf out "%d%%nat" i

let terms out =
  let print format = Printf.fprintf out format in
  let list separator write values =
    print "[";
    List.iteri
      (fun i value ->
        if i > 0 then print "%s" separator;
        write value)
      values;
    print "]"
  in
  let fraction num den =
    if Z.sign num < 0 then print "(%s)" (Z.to_string num) else print "%s" (Z.to_string num);
    if not (Z.equal den Z.one) then print "#%s" (Z.to_string den) else print "#1"
  in
  let number (q : Q.t) = fraction (Q.num q) (Q.den q) in
  let given (x, y) = print "("; number x; print ", "; number y; print ")" in
  let rings name value =
    print "  let %s : rings vertex :=\n  " name;
    list ";\n   " (list "; " given) value;
    print " in\n"
  in
  let q (f : Checker.q) = fraction f.qnum f.qden in
  let vertex = function
    | Checker.Fixed x, Checker.Fixed y -> print "fixed ("; q x; print ", "; q y; print ")"
    | _ -> invalid_arg "a theorem is about one scale"
  in
  let corners = list "; " vertex in
  let rec node = function
    | Checker.Piece v -> print "Piece "; corners v
    | Checker.Group (h, members) ->
      print "Group "; corners h; print " ";
      list ";\n   " node members
  in
  let natural = natural out in
  let solid (hull, leaves) = print "("; corners hull; print ", "; list "; " natural leaves;
    print ")" in
  let tiled name (t : Checker.tiled) =
    print "pose (%s := {|\n  root := " name;
    node t.root;
    print ";\n  solids := ";
    list ";\n   " solid t.solids;
    print " |} : tiled).\n"
  in
  let token = function
    | Checker.OpenP -> print "OpenP"
    | Checker.OpenQ -> print "OpenQ"
    | Checker.Normal n -> print "Normal ("; vertex n; print ")"
  in
  { list; number; given; rings; vertex; corners; tiled; token }

let write out s p other polygons derivation =
  let { Checker.region_of = witness; components_of = components; outside_of = outside;
        holes_of = holes; rows_of = rows } = Checked.shown derivation in
  let print format = Printf.fprintf out format in
  let { list; number; given; rings; vertex; corners; tiled; token } = terms out in
  let natural = natural out in
  let cell (at, proof) =
    print "("; corners at; print ", ";
    (match proof with
     | Checker.Covered (i, j, parts) -> print "Covered %d%%nat %d%%nat " i j; corners parts
     | Checker.Apart code -> print "Apart "; list "; " token code);
    print ")"
  in
  output_string out head;
  number s;
  print " in\n";
  rings "P" p;
  rings "Q'" other;
  print "  let R' : list (polygon vertex) :=\n  ";
  let ring = list "; " given in
  list ";\n   "
    (fun ({ outer; holes } : _ Reading.polygon) ->
      print "("; ring outer; print ",\n    "; list ";\n     " ring holes; print ")")
    polygons;
  print " in\n";
  output_string out (statement (List.length components) (List.length holes));
  output_string out proof;
  tiled "pieces_of_P" witness.of_P;
  tiled "pieces_of_Q" witness.of_Q;
  print "pose (proof_of_cells :=\n  ";
  list ";\n   " cell witness.cells;
  print " : list (list corner * proof)).\npose (proof_of_region := {|\n";
  print "  of_P := pieces_of_P; of_Q := pieces_of_Q;\n  box := ";
  corners witness.box;
  print ";\n  cells := proof_of_cells |} : witness).\n";
  let component (c : Checker.component) =
    print "{| size := "; natural c.size; print "; links := ";
    list "; " (fun (back, m) -> print "("; natural back; print ", "; vertex m; print ")") c.links;
    print ";\n    rim := ";
    list ";\n     "
      (fun (ring, others) ->
        print "("; corners ring; print ", "; list "; " natural others; print ")")
      c.rim;
    print " |}"
  in
  print "pose (components :=\n  ";
  list ";\n   " component components;
  print " : list component).\npose (outside :=\n  ";
  component outside;
  print " : component).\npose (holes :=\n  ";
  list ";\n   " component holes;
  print " : list component).\npose (rows :=\n  ";
  let stretch ((left, right), v) =
    print "("; natural left; print ", "; natural right; print ", "; vertex v; print ")"
  in
  list ";\n   " (list ";\n    " (list ";\n     " (list "; " stretch))) rows;
  print " : list (list (list (list stretch)))).\npose (everything := {|\n";
  print "  region_of := proof_of_region; components_of := components; outside_of := outside;\n";
  print "  holes_of := holes; rows_of := rows |} : derivation).\n";
  output_string out foot
