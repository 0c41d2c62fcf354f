(* SHA-256 (FIPS 180-4). Trusted: a claim names its sum by this digest. *)

let primes count =
  let rec go found n =
    if List.length found = count then List.rev found
    else if List.exists (fun p -> n mod p = 0) found then go found (n + 1)
    else go (n :: found) (n + 1)
  in
  go [] 2

(* The first 32 bits of the fraction of the root of a prime, by whole numbers *)
let fraction root p =
  let shifted = Z.shift_left (Z.of_int p) (32 * root) in
  Z.to_int (Z.logand (Z.root shifted root) (Z.of_int 0xFFFFFFFF))

let initial = Array.of_list (List.map (fraction 2) (primes 8))
let constants = Array.of_list (List.map (fraction 3) (primes 64))

let hex_digest text =
  let mask x = x land 0xFFFFFFFF in
  let turn x n = mask ((x lsr n) lor (x lsl (32 - n))) in
  let length = String.length text in
  let padded = Buffer.create (length + 72) in
  Buffer.add_string padded text;
  Buffer.add_char padded '\x80';
  while Buffer.length padded mod 64 <> 56 do Buffer.add_char padded '\x00' done;
  Buffer.add_int64_be padded (Int64.of_int (8 * length));
  let bytes = Buffer.contents padded in
  let state = Array.copy initial in
  let w = Array.make 64 0 in
  for block = 0 to (String.length bytes / 64) - 1 do
    for i = 0 to 15 do
      w.(i) <- mask (Int32.to_int (String.get_int32_be bytes ((64 * block) + (4 * i))))
    done;
    for i = 16 to 63 do
      let a = w.(i - 15) and b = w.(i - 2) in
      let s0 = turn a 7 lxor turn a 18 lxor (a lsr 3)
      and s1 = turn b 17 lxor turn b 19 lxor (b lsr 10) in
      w.(i) <- mask (w.(i - 16) + s0 + w.(i - 7) + s1)
    done;
    let v = Array.copy state in
    for i = 0 to 63 do
      let a = v.(0) and e = v.(4) in
      let s1 = turn e 6 lxor turn e 11 lxor turn e 25 in
      let choice = (e land v.(5)) lxor (mask (lnot e) land v.(6)) in
      let one = mask (v.(7) + s1 + choice + constants.(i) + w.(i)) in
      let s0 = turn a 2 lxor turn a 13 lxor turn a 22 in
      let majority = (a land v.(1)) lxor (a land v.(2)) lxor (v.(1) land v.(2)) in
      Array.blit v 0 v 1 7;
      v.(4) <- mask (v.(4) + one);
      v.(0) <- mask (one + mask (s0 + majority))
    done;
    Array.iteri (fun i x -> state.(i) <- mask (state.(i) + x)) v
  done;
  String.concat "" (Array.to_list (Array.map (Printf.sprintf "%08x") state))
