(* minkref-check-proved: certificates (docs/certificates.md) by a checker that is proved right in
   Coq (docs/proved.md). Limits and exit codes are those of the other checkers; 5: declined. *)

open Failure

let usage =
  "usage: minkref-check-proved [--case FILE] [--theorem FILE] [LIMITS] [--json] FILE...\n\
  \       minkref-check-proved --points [LIMITS] [--json] FILE...\n\
  \       minkref-check-proved --sum [LIMITS] [--json] FILE...\n\
  \       minkref-check-proved --combination [LIMITS] [--json] FILE...\n\
   LIMITS are --seconds N, --tests N, --bytes N. FILE is plain JSON; - is standard input. --json\n\
   says each verdict as a line of JSON, in the order of the files. --theorem writes the sum, or\n\
   the point, as a theorem of Coq.\n\
   --points decides without a certificate which points are in the sum of P, scaled, and Q:\n\
  \  {\"P\": {\"polygons\": []}, \"Q\": .., \"scale\": \"7/5\", \"points\": [[\"1/3\", 5]]}\n\
   --sum computes the sum of such a file without points; --combination what sets are together:\n\
  \  {\"operation\": \"union\", \"sets\": [{\"polygons\": []}, ..]}\n\
   or intersection or difference.\n\
   The programs decide whether sets are legal, and what they answer is proved to be right\n\
   (docs/proved.md).\n\
   Exit codes: 0 proved or answered, 1 refuted, 2 malformed, 4 out of budget, 5 declined: no\n\
   theorem.\n"

let unpack = "gzip -dc FILE | minkref-check-proved -, or minkref check FILE"

exception Wrong_usage

type answer = Certificates | Points | Sum | Combination

type options = {
  mutable answer : answer;
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
    { answer = Certificates; case = None; seconds = 600.; tests = 1e10; bytes = 268435456.;
      theorem = None; json = false; files = [] }
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
    | "--points" :: rest when options.answer = Certificates -> options.answer <- Points; go rest
    | "--sum" :: rest when options.answer = Certificates -> options.answer <- Sum; go rest
    | "--combination" :: rest when options.answer = Certificates ->
      options.answer <- Combination;
      go rest
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
  let asks = options.answer <> Certificates in
  if
    options.files = []
    || (options.theorem <> None && (asks || List.length options.files > 1))
    || (options.case <> None && asks)
  then raise Wrong_usage;
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

let most_bytes options = int_of_float (min options.bytes 4e18)

let budget_of options =
  let left = ref options.tests in
  fun tests ->
    left := !left -. float_of_int tests;
    if !left < 0. then fail Out_of_budget "a limit is reached (--seconds, --tests)"

let check_file options file =
  let most = most_bytes options and budget = budget_of options in
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

(* [shown]: the case of what is verified and its digest. [members]: of the line of JSON, beside
   verdict and reason *)
type verdict = {
  code : int;
  word : string;
  why : string;
  shown : (string * string) option;
  said : string list;
  members : string list;
}

let found options file =
  let good = { code = 0; word = "verified"; why = ""; shown = None; said = []; members = [] } in
  let text () = read ~input:(file = "-") file (most_bytes options) in
  let computed found =
    let said = Questions.set_said found in
    { good with word = "computed"; said; members = [ Questions.set_json found ] }
  in
  match options.answer with
  | Certificates ->
    let proved, case = check_file options file in
    let said = List.map (fun (claim : Claims.proved) -> claim.said) proved in
    { good with shown = Some case; said }
  | Points ->
    let found = Questions.points (Questions.question (text ())) (budget_of options) in
    let said = Questions.points_said found in
    { good with word = "decided"; said; members = [ Questions.points_json found ] }
  | Sum -> computed (Questions.sum (Questions.question (text ())) (budget_of options))
  | Combination ->
    computed (Questions.combination (Questions.combining (text ())) (budget_of options))

let verdict options file =
  let without code word why = { code; word; why; shown = None; said = []; members = [] } in
  try within_seconds options.seconds (fun () -> found options file) with
  | Not_verified (code, why) -> without (exit_code code) (word code) why
  | Out_of_memory | Stack_overflow -> without 4 "out of budget" "there is too little memory"
  | Sys_error why -> without 2 "malformed" why

let print options file { word; why; shown; said; members; _ } =
  if options.json then begin
    let named (path, digest) =
      Printf.sprintf "{\"path\": %s, \"sha256\": %s}" (Text.quoted path) (Text.quoted digest)
    in
    let of_certificate =
      if options.answer <> Certificates then []
      else
        [ "\"case\": " ^ Option.fold ~none:"null" ~some:named shown;
          "\"proved\": [" ^ String.concat ", " (List.map Text.quoted said) ^ "]" ]
    in
    let head = [ "\"verdict\": " ^ Text.quoted word; "\"why\": " ^ Text.quoted why ] in
    print_string ("{" ^ String.concat ", " (head @ of_certificate @ members) ^ "}\n")
  end
  else begin
    let why = if why = "" then "" else ": " ^ Text.on_one_line why in
    Printf.printf "%s: %s%s\n" (Text.on_one_line file) word why;
    Option.iter
      (fun (path, digest) ->
        Printf.printf "  case %s, %s\n" (Text.on_one_line path) (Text.on_one_line digest))
      shown;
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
