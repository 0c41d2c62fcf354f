(* A point that is in a sum, or is not, as a theorem in Coq, in the order of theorem.ml: first the
   statement, in the notions of Definitions.v, then the proof, by computation. Nothing here is
   trusted: the statement is there to be read. *)

let head where name =
  Printf.sprintf
    {|(** A point that is %s the Minkowski sum sP + Q of two sets of the plane, as a theorem.

    The sets are given by their rings: outer ones counter-clockwise, holes clockwise. What the
    statement means stands in Definitions.v of oracle/proved. How to check it, if it comes from
    somebody else: docs/proved.md *)
From Proved Require Import Definitions.
Open Scope Q_scope.

Theorem %s :
  let s := |}
    where name

(* The statement, whose [sign] is nothing, or not *)
let statement out s p other x sign =
  let { Theorem.number; given; rings; _ } = Theorem.terms out in
  number s;
  output_string out " in\n";
  rings "P" p;
  rings "Q'" other;
  output_string out "  let x : vertex := ";
  given x;
  Printf.fprintf out
    {| in
  %sexists p q, set_of (points P) p /\ set_of (points Q') q /\ point_of x = add (scale (Q2R s) p) q.
|}
    sign

let proof out files of_p of_q =
  let { Theorem.tiled; _ } = Theorem.terms out in
  Printf.fprintf out
    {|Proof. (* Nothing is believed of what follows. *)
From Proved Require Import Numbers Checker Figures %s.
intros s P Q' x.
|}
    files;
  tiled "pieces_of_P" (Checked.pieces_shown of_p);
  tiled "pieces_of_Q" (Checked.pieces_shown of_q)

(* What [checks] takes, [is_right] makes true. *)
let foot out name checks is_right given =
  Printf.fprintf out
    {|exact (%s s P Q' x %s
  (eq_refl true <: %s s P Q' x %s = true)).
Qed.
Print Assumptions %s.
|}
    is_right given checks given name

let outside out s p other x of_p of_q code =
  let name = "this_point_is_outside" in
  let { Theorem.list; token; _ } = Theorem.terms out in
  output_string out (head "not in" name);
  statement out s p other x "~ ";
  proof out "Outside" of_p of_q;
  output_string out "pose (code := ";
  list "; " token (Checked.code_shown code);
  output_string out " : list token).\n";
  foot out name "check_one_outside" "outside_is_right" "pieces_of_P pieces_of_Q code"

let inside out s p other x (a, b) of_p of_q i j =
  let name = "this_point_is_inside" in
  let { Theorem.given; _ } = Theorem.terms out in
  output_string out (head "in" name);
  statement out s p other x "";
  proof out "Canonical" of_p of_q;
  let place name at =
    Printf.fprintf out "pose (%s := " name;
    given at;
    output_string out " : vertex).\n"
  in
  place "part" a;
  place "other" b;
  output_string out "exists (point_of part), (point_of other).\n";
  foot out name "check_one_point" "one_point_is_right"
    (Printf.sprintf "part other pieces_of_P pieces_of_Q %d %d" i j)
