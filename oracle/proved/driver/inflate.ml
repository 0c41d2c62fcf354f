(* gzip (RFC 1952, 1951): one member and nothing after it. *)

open Failure

exception Ends

let order = [| 16; 17; 18; 0; 8; 7; 9; 6; 10; 5; 11; 4; 12; 3; 13; 2; 14; 1; 15 |]

let table count first step =
  (* bases and extra bits of lengths (step 4) and distances (step 2) *)
  let bases = Array.make count 0 and extra = Array.make count 0 in
  let base = ref first in
  for i = 0 to count - 1 do
    extra.(i) <- max 0 ((i / step) - 1);
    bases.(i) <- !base;
    base := !base + (1 lsl extra.(i))
  done;
  (bases, extra)

let length_bases, length_extra =
  let bases, extra = table 29 3 4 in
  bases.(28) <- 258;
  extra.(28) <- 0;
  (bases, extra)

let distance_bases, distance_extra = table 30 1 2

(* The number of codes of each length, and the symbols in order *)
let huffman lengths =
  let counts = Array.make 16 0 in
  Array.iter (fun l -> counts.(l) <- counts.(l) + 1) lengths;
  counts.(0) <- 0;
  let left = ref 1 in
  for l = 1 to 15 do
    left := (2 * !left) - counts.(l);
    if !left < 0 then raise Ends
  done;
  let coded = Array.fold_left ( + ) 0 counts in
  if !left > 0 && not (coded = 0 || (coded = 1 && counts.(1) = 1)) then raise Ends;
  let starts = Array.make 17 0 in
  for l = 1 to 15 do starts.(l + 1) <- starts.(l) + counts.(l) done;
  let symbols = Array.make (Array.length lengths) 0 in
  Array.iteri
    (fun symbol l ->
      if l > 0 then (symbols.(starts.(l)) <- symbol; starts.(l) <- starts.(l) + 1))
    lengths;
  (counts, symbols)

let crc_table =
  Array.init 256 (fun n ->
      let c = ref n in
      for _ = 1 to 8 do c := if !c land 1 = 1 then 0xEDB88320 lxor (!c lsr 1) else !c lsr 1 done;
      !c)

let crc text =
  let c = ref 0xFFFFFFFF in
  String.iter (fun b -> c := crc_table.((!c lxor Char.code b) land 0xFF) lxor (!c lsr 8)) text;
  !c lxor 0xFFFFFFFF

let gunzip packed most =
  let n = String.length packed in
  let at = ref 0 and bits = ref 0 and held = ref 0 in
  let byte () =
    if !at >= n then raise Ends;
    incr at;
    Char.code packed.[!at - 1]
  in
  let take count =
    while !held < count do
      bits := !bits lor (byte () lsl !held);
      held := !held + 8
    done;
    let found = !bits land ((1 lsl count) - 1) in
    bits := !bits lsr count;
    held := !held - count;
    found
  in
  let decode (counts, symbols) =
    let rec go length code first index =
      if length > 15 then raise Ends;
      let code = code lor take 1 in
      let count = counts.(length) in
      if code - count < first then symbols.(index + code - first)
      else go (length + 1) ((code) lsl 1) ((first + count) lsl 1) (index + count)
    in
    go 1 0 0 0
  in
  let out = Buffer.create (4 * n) in
  let put c =
    if Buffer.length out > most then fail Out_of_budget "it is too large (--bytes)";
    Buffer.add_char out c
  in
  let rec codes literals distances =
    let symbol = decode literals in
    if symbol < 256 then (put (Char.chr symbol); codes literals distances)
    else if symbol > 256 then begin
      if symbol > 285 then raise Ends;
      let length = length_bases.(symbol - 257) + take length_extra.(symbol - 257) in
      let d = decode distances in
      if d > 29 then raise Ends;
      let distance = distance_bases.(d) + take distance_extra.(d) in
      if distance > Buffer.length out then raise Ends;
      for _ = 1 to length do put (Buffer.nth out (Buffer.length out - distance)) done;
      codes literals distances
    end
  in
  let stored () =
    bits := 0;
    held := 0;
    let length = byte () in
    let length = length lor (byte () lsl 8) in
    let other = byte () in
    let other = other lor (byte () lsl 8) in
    if length lxor other <> 0xFFFF then raise Ends;
    for _ = 1 to length do put (Char.chr (byte ())) done
  in
  let fixed () =
    let length i = if i < 144 then 8 else if i < 256 then 9 else if i < 280 then 7 else 8 in
    codes (huffman (Array.init 288 length)) (huffman (Array.make 32 5))
  in
  let dynamic () =
    let literals = 257 + take 5 in
    let distances = 1 + take 5 in
    let count = 4 + take 4 in
    if literals > 286 || distances > 30 then raise Ends;
    let small = Array.make 19 0 in
    for i = 0 to count - 1 do small.(order.(i)) <- take 3 done;
    let small = huffman small in
    let lengths = Array.make (literals + distances) 0 in
    let i = ref 0 in
    let repeat value times =
      if !i + times > Array.length lengths then raise Ends;
      Array.fill lengths !i times value;
      i := !i + times
    in
    while !i < Array.length lengths do
      match decode small with
      | 16 -> if !i = 0 then raise Ends else repeat lengths.(!i - 1) (3 + take 2)
      | 17 -> repeat 0 (3 + take 3)
      | 18 -> repeat 0 (11 + take 7)
      | length -> repeat length 1
    done;
    if lengths.(256) = 0 then raise Ends;
    codes
      (huffman (Array.sub lengths 0 literals))
      (huffman (Array.sub lengths literals distances))
  in
  let rec blocks () =
    let last = take 1 in
    (match take 2 with 0 -> stored () | 1 -> fixed () | 2 -> dynamic () | _ -> raise Ends);
    if last = 0 then blocks ()
  in
  try
    let header = Array.init 10 (fun _ -> byte ()) in
    if header.(2) <> 8 || header.(3) land 0xE0 <> 0 then raise Ends;
    let flags = header.(3) in
    let skip_text () = while byte () <> 0 do () done in
    if flags land 4 <> 0 then begin
      let length = byte () in
      let length = length lor (byte () lsl 8) in
      for _ = 1 to length do ignore (byte ()) done
    end;
    if flags land 8 <> 0 then skip_text ();
    if flags land 16 <> 0 then skip_text ();
    if flags land 2 <> 0 then (ignore (byte ()); ignore (byte ()));
    blocks ();
    bits := 0;
    held := 0;
    let word () =
      let a = byte () in
      let b = byte () in
      let c = byte () in
      a lor (b lsl 8) lor (c lsl 16) lor (byte () lsl 24)
    in
    let text = Buffer.contents out in
    let sum = word () in
    let size = word () in
    if sum <> crc text || size <> String.length text land 0xFFFFFFFF || !at < n then raise Ends;
    text
  with Ends -> fail Malformed "it is not one whole compressed file"
