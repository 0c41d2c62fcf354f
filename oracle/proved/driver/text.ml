(* Texts of others on a line of their own: names of files, and what certificates say. *)

(* Calls [letter] with each letter of UTF-8 and its number, [byte] with each byte that is none *)
let read ~letter ~byte text =
  let n = String.length text in
  let number piece =
    let bits code c = (code lsl 6) lor (Char.code c land 0x3f) in
    let first = Char.code piece.[0] and size = String.length piece in
    if size = 1 then first
    else String.fold_left bits 0 piece land ((1 lsl ((5 * size) + 1)) - 1)
  in
  let rec from i =
    if i < n then
      let size = if i + 4 <= n then 4 else n - i in
      let pieces = List.init size (fun k -> String.sub text i (k + 1)) in
      match List.find_opt Json.is_utf8 pieces with
      | Some piece -> letter piece (number piece); from (i + String.length piece)
      | None -> byte (Char.code text.[i]); from (i + 1)
  in
  from 0

(* Control characters, ends of lines of Unicode among them, and bytes that are no text, by their
   numbers *)
let on_one_line text =
  let line = Buffer.create (String.length text) in
  let byte code = Printf.bprintf line "\\x%02x" code in
  let letter piece code =
    let is_plain = code >= 0x20 && (code < 0x7f || code > 0x9f) && code <> 0x5c in
    if is_plain && code <> 0x2028 && code <> 0x2029 then Buffer.add_string line piece
    else String.iter (fun c -> byte (Char.code c)) piece
  in
  read ~letter ~byte text;
  Buffer.contents line

(* A text of JSON in ASCII. A byte that is no UTF-8 is a lone surrogate, as Python has it. *)
let quoted text =
  let found = Buffer.create (String.length text + 2) in
  let escape code = Printf.bprintf found "\\u%04x" code in
  let letter piece code =
    if code >= 0x10000 then begin
      escape (0xd7c0 + (code lsr 10));
      escape (0xdc00 + (code land 0x3ff))
    end
    else if code < 0x20 || code > 0x7e || code = 0x22 || code = 0x5c then escape code
    else Buffer.add_string found piece
  in
  Buffer.add_char found '"';
  read ~letter ~byte:(fun code -> escape (0xdc00 + code)) text;
  Buffer.add_char found '"';
  Buffer.contents found
