(* Certificates of sums of convex polyhedra (docs/certificates-convex.md). Trusted: what is said to
   be proved is what [Checked] was asked, of the polyhedra of the case and the sums claimed. *)

open Failure
open Json

type point = Q.t * Q.t * Q.t
type body = { vertices : point list; faces : int list list }

let point value : point =
  match items value with
  | [ x; y; z ] -> (number x, number y, number z)
  | _ -> fail Malformed "a point has three coordinates"

let same (a, b, c) (d, e, f) = Q.equal a d && Q.equal b e && Q.equal c f
let are_different values = List.length (List.sort_uniq compare values) = List.length values

let rings name faces bound =
  let ring value = List.map (fun i -> index i bound) (items value) in
  let rings = List.map ring faces in
  require (rings <> []) (name ^ " has no face");
  require
    (List.for_all (fun ring -> List.length ring > 2 && are_different ring) rings)
    (name ^ " has a face that is no ring");
  require
    (List.length (List.sort_uniq compare (List.concat rings)) = bound)
    (name ^ " has a vertex in no face");
  rings

(* The JSON that is hashed: numbers in lowest terms *)
let hashed { vertices; faces } =
  let list write values = "[" ^ String.concat "," (List.map write values) ^ "]" in
  let vertex (x, y, z) =
    Printf.sprintf "[\"%s\",\"%s\",\"%s\"]" (Q.to_string x) (Q.to_string y) (Q.to_string z)
  in
  Printf.sprintf "{\"faces\":%s,\"vertices\":%s}"
    (list (list string_of_int) faces)
    (list vertex vertices)

let operand name value =
  match members value [ "vertices"; "faces" ] with
  | [ vertices; faces ] ->
    let vertices = List.map point (items vertices) in
    let shown (x, y, z) = List.map Q.to_string [ x; y; z ] in
    require (are_different (List.map shown vertices)) (name ^ " has a point twice");
    let body = { vertices; faces = rings name (items faces) (List.length vertices) } in
    require (Faces.goes_around_once body.vertices body.faces)
      (name ^ " goes around its hull more than once");
    body
  | _ -> assert false

type sum = { scaling : point; pairs : (int * int) list; body : body }

(* A facet's ring. Its parents are the vertices farthest along its normal: no claim needs them. *)
let facet vertices scaled_p of_q value =
  match items value with
  | [ ring; parents_of_p; parents_of_q ] ->
    let corners =
      List.map (fun i -> vertices.(index i (Array.length vertices))) (items ring)
    in
    let n = Faces.area_vector corners in
    let are_farthest body given =
      let most = Faces.farthest n body in
      let given = List.map (fun i -> index i (Array.length body)) (items given) in
      demand (given = most) "other vertices of P or Q are farthest"
    in
    are_farthest scaled_p parents_of_p;
    are_farthest of_q parents_of_q;
    ring
  | _ -> fail Malformed "a facet has a ring and its parents"

let sum_of p q value =
  match members value [ "scaling"; "vertices"; "facets" ] with
  | [ scaling; vertices; facets ] ->
    let ((sx, sy, sz) as scaling) = point scaling in
    require (List.for_all (fun s -> Q.sign s > 0) [ sx; sy; sz ]) "a factor is not positive";
    let of_p = Array.of_list p.vertices and of_q = Array.of_list q.vertices in
    let pair value =
      let i, j = pair value in
      (index i (Array.length of_p), index j (Array.length of_q))
    in
    let pairs = List.map pair (items vertices) in
    let vertex (i, j) =
      let (a, b, c), (d, e, f) = (of_p.(i), of_q.(j)) in
      Q.(((sx * a) + d, (sy * b) + e, (sz * c) + f))
    in
    let scaled = Array.map (fun (a, b, c) -> Q.(sx * a, sy * b, sz * c)) of_p in
    let scaled = Array.map Faces.over_one scaled and of_q = Array.map Faces.over_one of_q in
    let vertices = List.map vertex pairs in
    let facet = facet (Array.of_list vertices) scaled of_q in
    let faces = rings "a sum" (List.map facet (items facets)) (List.length pairs) in
    { scaling; pairs; body = { vertices; faces } }
  | _ -> assert false

let check_claim budget p q sum claim =
  budget 64;
  match
    members claim [ "claim"; "sum"; "scaling"; "vertices"; "facets"; "volume"; "digest" ]
  with
  | [ kind; at; scaling; vertices; facets; volume; digest ] ->
    require (text kind = "sum") "there is no such claim";
    let { scaling = s; pairs; body } = Lazy.force (sum at) in
    demand (same (point scaling) s) "the sum is at another scaling";
    let is_count value list = Z.equal (integer value) (Z.of_int (List.length list)) in
    demand (is_count vertices body.vertices && is_count facets body.faces)
      "vertices or facets are not so many";
    demand (Sha256.hex_digest (hashed body) = text digest) "the digest is another";
    let mesh { vertices; faces } = (vertices, faces) in
    budget (List.length body.faces * (List.length p.vertices + List.length q.vertices));
    demand
      (Checked.body_holds s (mesh p) (mesh q) (mesh body) pairs)
      "the proved checker does not take this for a proof";
    let found = Checked.volume (mesh body) in
    demand (Q.equal (number volume) found) "the volume is another";
    let x, y, z = s in
    Printf.sprintf "sum: at (%s, %s, %s), the set of points of digest %s, of %d facets, volume %s"
      (Q.to_string x) (Q.to_string y) (Q.to_string z) (text digest) (List.length body.faces)
      (Q.to_string found)
  | _ -> assert false

(* What is proved; Not_verified where a claim does not hold *)
let check certificate read_case budget =
  match
    members certificate
      [ "certificate"; "title?"; "comment?"; "producer?"; "case"; "sums"; "claims" ]
  with
  | [ _; title; comment; producer; case; sums; claims ] ->
    let path, digest = Reading.head [ title; comment; producer ] case in
    let p, q =
      match read_case path with
      | Object found ->
        require
          (match List.assoc_opt "dimension" found with
           | Some (Integer word) -> Z.equal (Z.of_string word) (Z.of_int 3)
           | _ -> false)
          "the case is not of dimension 3";
        let named name =
          match List.assoc_opt name found with
          | Some value -> operand name value
          | None -> fail Malformed ("the case has no " ^ name)
        in
        (named "P", named "Q")
      | _ -> fail Malformed "this is no case"
    in
    demand
      (Sha256.hex_digest (Printf.sprintf "{\"P\":%s,\"Q\":%s}" (hashed p) (hashed q)) = digest)
      "not the case that is certified";
    let given = Array.of_list (List.map (fun value -> lazy (sum_of p q value)) (items sums)) in
    let used = Hashtbl.create 16 in
    let sum at =
      let i = index at (Array.length given) in
      Hashtbl.replace used i ();
      given.(i)
    in
    let claims = items claims in
    require (claims <> []) "nothing is claimed";
    let said =
      List.mapi
        (fun i claim ->
          within (Printf.sprintf "claim %d" i) (fun () -> check_claim budget p q sum claim))
        claims
    in
    require (Hashtbl.length used = Array.length given) "a sum is not used";
    let scalings = Array.to_list (Array.map (fun sum -> (Lazy.force sum).scaling) given) in
    let shown (x, y, z) = List.map Q.to_string [ x; y; z ] in
    require (are_different (List.map shown scalings)) "two sums are at one scaling";
    require (are_different (List.map canonical_text claims)) "a claim is made twice";
    said
  | _ -> assert false
