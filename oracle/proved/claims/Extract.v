(** The checker as an OCaml program over zarith's integers. Trusted: extraction, OCaml, zarith, and
    the constant below: Coq's Z.ggcd, by which fractions are reduced, in zarith's words. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlZBigInt ExtrOcamlNatInt ZArith.
From Proved Require Import Checker Figures Signs Passages Outside Space Hulls Moves Events Clear
  Collisions Traps Validity Answers.
Extract Constant Z.ggcd => "(fun a b -> let g = Z.gcd a b in
  if Z.equal g Z.zero then (g, (Z.zero, Z.zero)) else (g, (Z.divexact a g, Z.divexact b g)))".
Extraction "checker.ml" check_form check_one_point check_one_outside check_sign check_one_passage
  check_body volume check_interval check_event check_free check_hit check_valid check_escapes
  check_trapped check_trap decide_points decide_legal verified_sum
  verified_combination.
