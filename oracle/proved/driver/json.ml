(* JSON as docs/certificates.md restricts it: no member twice, no escaped surrogate, no byte order
   mark, at most 500 levels, integers; numbers with a point or an exponent only where [decimals]. *)

open Failure

type value =
  | Null
  | Bool of bool
  | Integer of string
  | Decimal of string
  | Text of string
  | List of value list
  | Object of (string * value) list

let most_levels = 500
let most_digits = 100_000

(* Whether bytes are UTF-8, without overlong forms and surrogates. *)
let is_utf8 text =
  let n = String.length text in
  let byte i = if i < n then Char.code text.[i] else 0 in
  let follows i = byte i land 0xC0 = 0x80 in
  let rec from i =
    if i >= n then true
    else
      let b = byte i in
      if b < 0x80 then from (i + 1)
      else if b >= 0xC2 && b < 0xE0 then follows (i + 1) && from (i + 2)
      else if b land 0xF0 = 0xE0 then
        let c = byte (i + 1) in
        (not (b = 0xE0 && c < 0xA0)) && (not (b = 0xED && c >= 0xA0))
        && follows (i + 1) && follows (i + 2) && from (i + 3)
      else if b >= 0xF0 && b < 0xF5 then
        let c = byte (i + 1) in
        (not (b = 0xF0 && c < 0x90)) && (not (b = 0xF4 && c >= 0x90))
        && follows (i + 1) && follows (i + 2) && follows (i + 3) && from (i + 4)
      else false
  in
  from 0

let parse ~decimals text =
  let n = String.length text in
  require (is_utf8 text) "it is not UTF-8";
  let at = ref 0 in
  let no what = fail Malformed (Printf.sprintf "it is not JSON at byte %d: %s" !at what) in
  let peek () = if !at < n then text.[!at] else '\000' in
  let rec space () =
    if !at < n then
      match text.[!at] with
      | ' ' | '\t' | '\n' | '\r' -> incr at; space ()
      | _ -> ()
  in
  let expect c = if !at < n && text.[!at] = c then incr at else no (Printf.sprintf "%C" c) in
  let literal word value =
    let m = String.length word in
    if !at + m <= n && String.sub text !at m = word then (at := !at + m; value) else no "a value"
  in
  let hex () =
    let value = ref 0 in
    for _ = 1 to 4 do
      (match peek () with
       | '0' .. '9' as c -> value := (!value * 16) + Char.code c - 48
       | 'a' .. 'f' as c -> value := (!value * 16) + Char.code c - 87
       | 'A' .. 'F' as c -> value := (!value * 16) + Char.code c - 55
       | _ -> no "four hexadecimal digits");
      incr at
    done;
    !value
  in
  let string () =
    expect '"';
    let buffer = Buffer.create 16 in
    let rec go () =
      if !at >= n then no "a text ends"
      else
        match text.[!at] with
        | '"' -> incr at
        | '\\' ->
          incr at;
          let c = peek () in
          incr at;
          (match c with
           | '"' | '\\' | '/' -> Buffer.add_char buffer c
           | 'b' -> Buffer.add_char buffer '\b'
           | 'f' -> Buffer.add_char buffer '\012'
           | 'n' -> Buffer.add_char buffer '\n'
           | 'r' -> Buffer.add_char buffer '\r'
           | 't' -> Buffer.add_char buffer '\t'
           | 'u' ->
             let code = hex () in
             require (code < 0xD800 || code > 0xDFFF) "it escapes a surrogate";
             Buffer.add_utf_8_uchar buffer (Uchar.of_int code)
           | _ -> no "an escape");
          go ()
        | c when c < ' ' -> no "a control character"
        | c -> Buffer.add_char buffer c; incr at; go ()
    in
    go ();
    Buffer.contents buffer
  in
  let digits () =
    let from = !at in
    while (match peek () with '0' .. '9' -> true | _ -> false) do incr at done;
    if !at = from then no "a digit"
  in
  let number () =
    let from = !at in
    if peek () = '-' then incr at;
    if peek () = '0' then incr at else digits ();
    let whole = ref true in
    if peek () = '.' then (whole := false; incr at; digits ());
    (match peek () with
     | 'e' | 'E' ->
       whole := false;
       incr at;
       (match peek () with '+' | '-' -> incr at | _ -> ());
       digits ()
     | _ -> ());
    let word = String.sub text from (!at - from) in
    require (String.length word <= most_digits) "a number is too long";
    require (!whole || decimals) "a number with a point or an exponent";
    if !whole then Integer word else Decimal word
  in
  let rec value level =
    require (level <= most_levels) "there are too many levels";
    space ();
    match peek () with
    | '{' ->
      incr at;
      let seen = Hashtbl.create 8 in
      let rec go found =
        space ();
        let name = string () in
        require (not (Hashtbl.mem seen name)) "an object has a member twice";
        Hashtbl.add seen name ();
        space ();
        expect ':';
        let found = (name, value (level + 1)) :: found in
        space ();
        if peek () = ',' then (incr at; go found) else (expect '}'; List.rev found)
      in
      space ();
      if peek () = '}' then (incr at; Object []) else Object (go [])
    | '[' ->
      incr at;
      let rec go found =
        let found = value (level + 1) :: found in
        space ();
        if peek () = ',' then (incr at; go found) else (expect ']'; List.rev found)
      in
      space ();
      if peek () = ']' then (incr at; List []) else List (go [])
    | '"' -> Text (string ())
    | 't' -> literal "true" (Bool true)
    | 'f' -> literal "false" (Bool false)
    | 'n' -> literal "null" Null
    | '-' | '0' .. '9' -> number ()
    | _ -> no "a value"
  in
  let found = value 1 in
  space ();
  if !at < n then no "its end";
  found

(* The text of a value without white space, members in the order of their names *)
let rec canonical_text = function
  | Null -> "null"
  | Bool found -> string_of_bool found
  | Integer word -> Z.to_string (Z.of_string word)
  | Decimal word -> word
  | Text found -> Printf.sprintf "%S" found
  | List found -> "[" ^ String.concat "," (List.map canonical_text found) ^ "]"
  | Object found ->
    let member (name, value) = Printf.sprintf "%S:%s" name (canonical_text value) in
    let sorted = List.sort (fun (a, _) (b, _) -> compare a b) found in
    "{" ^ String.concat "," (List.map member sorted) ^ "}"

(* The members of an object in the order of [names]; no other may be there, and only those that
   end in ? may lack, and are Null then. *)
let members value names =
  match value with
  | Object found ->
    let plain name =
      let m = String.length name in
      if name.[m - 1] = '?' then String.sub name 0 (m - 1) else name
    in
    let known = List.map plain names in
    List.iter (fun (name, _) -> require (List.mem name known) "there are unknown members") found;
    List.map
      (fun name ->
        match List.assoc_opt (plain name) found with
        | Some value -> value
        | None ->
          require (plain name <> name) ("a member is missing: " ^ name);
          Null)
      names
  | _ -> fail Malformed ("an object is missing, with " ^ String.concat ", " names)

let items = function List found -> found | _ -> fail Malformed "a list is missing"
let pair value =
  match items value with [ a; b ] -> (a, b) | _ -> fail Malformed "a list has not two entries"
let text = function Text found -> found | _ -> fail Malformed "a text is missing"

let integer = function
  | Integer word -> Z.of_string word
  | _ -> fail Malformed "an integer is missing"

(* A number from 0 to [bound] - 1 *)
let index value bound =
  let found = integer value in
  require (Z.sign found >= 0 && Z.lt found (Z.of_int bound)) "there is no such number before this";
  Z.to_int found

(* Whole digits, with a point, with an exponent of at most 1000; or digits / digits *)
let rational word =
  let n = String.length word in
  require (n <= most_digits) "a number is too long";
  let bad () = fail Malformed (Printf.sprintf "%S is no number" (String.sub word 0 (min n 60))) in
  let is_digits t = t <> "" && String.for_all (fun c -> c >= '0' && c <= '9') t in
  let negative = n > 0 && word.[0] = '-' in
  let body =
    if n > 0 && (word.[0] = '-' || word.[0] = '+') then String.sub word 1 (n - 1) else word
  in
  let size =
    match String.index_opt body '/' with
    | Some i ->
      let above = String.sub body 0 i
      and below = String.sub body (i + 1) (String.length body - i - 1) in
      if not (is_digits above && is_digits below) then bad ();
      let below = Z.of_string below in
      if Z.equal below Z.zero then bad ();
      Q.make (Z.of_string above) below
    | None ->
      let mantissa, power =
        match String.index_opt (String.lowercase_ascii body) 'e' with
        | None -> (body, 0)
        | Some i ->
          let e = String.sub body (i + 1) (String.length body - i - 1) in
          let m = String.length e in
          let unsigned =
            if m > 0 && (e.[0] = '-' || e.[0] = '+') then String.sub e 1 (m - 1) else e
          in
          let fits = String.length unsigned <= 3 || unsigned = "1000" in
          if not (is_digits unsigned && fits) then bad ();
          let size = int_of_string unsigned in
          (String.sub body 0 i, if e.[0] = '-' then -size else size)
      in
      let whole, part =
        match String.index_opt mantissa '.' with
        | None -> (mantissa, "")
        | Some i ->
          let rest = String.length mantissa - i - 1 in
          (String.sub mantissa 0 i, String.sub mantissa (i + 1) rest)
      in
      if not (is_digits (whole ^ part)) then bad ();
      let digits = Q.of_bigint (Z.of_string (whole ^ part)) in
      let shift = power - String.length part in
      let ten = Q.of_bigint (Z.pow (Z.of_int 10) (abs shift)) in
      if shift >= 0 then Q.mul digits ten else Q.div digits ten
  in
  if negative then Q.neg size else size

let number = function
  | Integer word | Decimal word | Text word -> rational word
  | _ -> fail Malformed "a number is missing"
