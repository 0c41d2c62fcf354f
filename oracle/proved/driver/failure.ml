(* Why a file is not verified: the exit codes of docs/certificates.md, and 5. *)

type code = Refuted | Malformed | Out_of_budget | Declined

exception Not_verified of code * string

let exit_code = function Refuted -> 1 | Malformed -> 2 | Out_of_budget -> 4 | Declined -> 5

let word = function
  | Refuted -> "refuted"
  | Malformed -> "malformed"
  | Out_of_budget -> "out of budget"
  | Declined -> "declined"

let fail code what = raise (Not_verified (code, what))
let demand condition what = if not condition then fail Refuted what
let require condition what = if not condition then fail Malformed what

(* What is wrong inside is said with its place. *)
let within place action =
  try action ()
  with Not_verified (code, what) -> raise (Not_verified (code, place ^ ": " ^ what))
