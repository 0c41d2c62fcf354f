(* minkref-check-proved: certificates (docs/certificates.md) by a checker that is proved right in
   Coq (docs/proved.md). Limits and exit codes are those of the other checkers; 5: declined. *)

open Failure

let usage =
  "usage: minkref-check-proved [--case FILE] [--seconds N] [--tests N] [--bytes N] \
   [--theorem FILE] [--json] FILE...\n\
   FILE is plain JSON; - is standard input. --theorem writes the sum, or the point, as a theorem\n\
   of Coq. --json says each verdict as a line of JSON, in the order of the files.\n\
   Exit codes: 0 proved, 1 refuted, 2 malformed, 4 out of budget, 5 declined: no theorem.\n"

let unpack = "gzip -dc FILE | minkref-check-proved -, or minkref check FILE"

exception Wrong_usage

type options = {
  mutable case : string option;
  mutable seconds : float;
  mutable tests : float;
  mutable bytes : float;
  mutable theorem : string option;
  mutable json : bool;
  mutable files : string list;  (* the last first *)
}

let options_of words =
  let options =
    { case = None; seconds = 600.; tests = 1e10; bytes = 268435456.; theorem = None; json = false;
      files = [] }
  in
  let limit word =
    let plain = String.for_all (fun c -> String.contains "0123456789.eE+" c) word in
    match float_of_string_opt word with
    | Some found when plain && found >= 0. && found <= 1e18 -> found
    | _ -> raise Wrong_usage
  in
  let set name value =
    match name with
    | "--case" -> options.case <- Some value
    | "--seconds" -> options.seconds <- limit value
    | "--tests" -> options.tests <- limit value
    | "--bytes" -> options.bytes <- limit value
    | "--theorem" -> options.theorem <- Some value
    | _ -> raise Wrong_usage
  in
  let rec go = function
    | [] -> ()
    | "--" :: rest -> List.iter (fun file -> options.files <- file :: options.files) rest
    | "--json" :: rest -> options.json <- true; go rest
    | word :: rest when word <> "-" && word <> "" && word.[0] = '-' -> (
      match (String.index_opt word '=', rest) with
      | Some i, _ ->
        set (String.sub word 0 i) (String.sub word (i + 1) (String.length word - i - 1));
        go rest
      | None, value :: rest -> set word value; go rest
      | None, [] -> raise Wrong_usage)
    | word :: rest ->
      options.files <- word :: options.files;
      go rest
  in
  go words;
  if options.files = [] || (options.theorem <> None && List.length options.files > 1) then
    raise Wrong_usage;
  options

let demand_size size most =
  if size > most then fail Out_of_budget "a file is too large (--bytes)"

let regular path =
  let absent () = fail Malformed (path ^ " cannot be read: it is no file") in
  match Unix.stat path with
  | { Unix.st_kind = Unix.S_REG; _ } -> ()
  | _ -> absent ()
  | exception Unix.Unix_error _ -> absent ()

(* All of a channel, of which more than `most` bytes are not kept *)
let rec drain channel buffer most =
  let room = min 65536 (most + 1 - Buffer.length buffer) in
  match Buffer.add_channel buffer channel room with
  | () -> demand_size (Buffer.length buffer) most; drain channel buffer most
  | exception End_of_file -> demand_size (Buffer.length buffer) most

let read ~input path most =
  let buffer = Buffer.create 65536 in
  (try
     if input then drain stdin buffer most
     else begin
       regular path;
       let file = open_in_bin path in
       Fun.protect ~finally:(fun () -> close_in_noerr file) (fun () -> drain file buffer most)
     end
   with Sys_error _ -> fail Malformed (path ^ " cannot be read"));
  let text = Buffer.contents buffer in
  if String.starts_with ~prefix:"\x1f\x8b" text then
    fail Malformed (path ^ " is compressed by gzip: " ^ unpack);
  text

let write_theorem path proved =
  match List.filter_map (fun (claim : Claims.proved) -> claim.theorem) proved with
  | [] -> fail Declined "no sum or point is claimed of which a theorem could be written"
  | _ :: _ :: _ ->
    fail Malformed "several sums or points are claimed: a theorem is about one (--theorem)"
  | [ write ] ->
    let out = open_out_bin path in
    Fun.protect ~finally:(fun () -> close_out out) (fun () -> write out)

let check_file options file =
  let most = int_of_float (min options.bytes 4e18) in
  let left = ref options.tests in
  let budget tests =
    left := !left -. float_of_int tests;
    if !left < 0. then fail Out_of_budget "a limit is reached (--seconds, --tests)"
  in
  let from = ref "" in
  let read_case name =
    require
      (options.case <> None || Reading.is_inside name)
      ("the case " ^ name ^ " is in another folder: give --case FILE");
    let folder = Filename.dirname file in
    let beside = if folder = "." then name else Filename.concat folder name in
    from := Option.value options.case ~default:beside;
    Json.parse ~decimals:true (read ~input:false !from most)
  in
  let certificate = Json.parse ~decimals:false (read ~input:(file = "-") file most) in
  let proved = Claims.check certificate read_case budget in
  Option.iter (fun path -> write_theorem path proved) options.theorem;
  (proved, (!from, Reading.digest_named certificate))

(* A signal ends what takes longer than it may. *)
let within_seconds seconds action =
  let late _ = fail Out_of_budget "a limit is reached (--seconds, --tests)" in
  if seconds <= 0. then late 0;
  let set it_value =
    ignore (Unix.setitimer Unix.ITIMER_REAL { Unix.it_interval = 0.; it_value })
  in
  Sys.set_signal Sys.sigalrm (Sys.Signal_handle late);
  set (min seconds 1e9);
  Fun.protect ~finally:(fun () -> set 0.) action

type verdict = {
  code : int;
  word : string;
  why : string;
  said : string list;
  case : (string * string) option;  (* its file, and its digest *)
}

let verdict options file =
  let without code word why = { code; word; why; said = []; case = None } in
  try
    let proved, case = within_seconds options.seconds (fun () -> check_file options file) in
    let said = List.map (fun (claim : Claims.proved) -> claim.said) proved in
    { code = 0; word = "verified"; why = ""; said; case = Some case }
  with
  | Not_verified (code, why) -> without (exit_code code) (word code) why
  | Out_of_memory | Stack_overflow -> without 4 "out of budget" "there is too little memory"
  | Sys_error why -> without 2 "malformed" why

let print options file { word; why; said; case; _ } =
  if options.json then
    let named (path, digest) =
      Printf.sprintf "{\"path\": %s, \"sha256\": %s}" (Text.quoted path) (Text.quoted digest)
    in
    Printf.printf "{\"verdict\": %s, \"why\": %s, \"case\": %s, \"proved\": [%s]}\n"
      (Text.quoted word) (Text.quoted why)
      (Option.fold ~none:"null" ~some:named case)
      (String.concat ", " (List.map Text.quoted said))
  else begin
    let why = if why = "" then "" else ": " ^ Text.on_one_line why in
    Printf.printf "%s: %s%s\n" (Text.on_one_line file) word why;
    Option.iter
      (fun (path, digest) ->
        Printf.printf "  case %s, %s\n" (Text.on_one_line path) (Text.on_one_line digest))
      case;
    List.iter (fun line -> Printf.printf "  %s\n" (Text.on_one_line line)) said
  end

let () =
  Gc.set { (Gc.get ()) with minor_heap_size = 1 lsl 20; space_overhead = 200 };
  match Array.to_list Sys.argv with
  | [ _; "--help" ] -> print_string usage
  | _ :: words -> (
    match options_of words with
    | options ->
      let check file =
        let found = verdict options file in
        print options file found;
        found.code
      in
      let codes = List.map check (List.rev options.files) in
      let worst = List.find_opt (fun code -> List.mem code codes) [ 1; 2; 4; 5 ] in
      (try flush stdout with Sys_error _ -> Unix._exit 70);
      exit (Option.value worst ~default:0)
    | exception Wrong_usage -> prerr_string usage; exit 2)
  | [] -> exit 2
