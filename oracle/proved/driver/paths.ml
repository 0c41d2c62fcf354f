(* Certificates of paths and traps (docs/certificates-paths.md). Trusted: what is said to be proved
   is what [Checked] was asked, of the part, the obstacles and the path of the case. *)

open Failure
open Json

type step =
  | Pieces of string * Pieces.side
  | Clear of Ways.clear

(* A claim about scales, for `valid` and `trap` *)
type part =
  | Of_path of Checked.path_claim
  | Of_place of Checked.place_claim
  | Of_both of Checked.hit list

type claim = {
  said : string;
  holds : bool Lazy.t;
  kind : string;
  contact : Reading.contact;
  scales : Reading.scales;
  by : int * int;
  part : part option;
  tests : int;
}

let shown_scales ({ low; high; low_in; high_in } : Reading.scales) =
  Printf.sprintf "%c%s, %s%c"
    (if low_in then '[' else '(')
    (Q.to_string low)
    (match high with None -> "infinity" | Some b -> Q.to_string b)
    (if high_in then ']' else ')')

let shown_list = function
  | [] -> "none"
  | found -> String.concat ", " (List.map shown_scales found)

let path_text path =
  let place (x, y) = Printf.sprintf "[\"%s\",\"%s\"]" (Q.to_string x) (Q.to_string y) in
  "[" ^ String.concat "," (List.map place path) ^ "]"

let digest (r : Reading.operand) (o : Reading.operand) path =
  Sha256.hex_digest
    (Printf.sprintf "{\"O\":%s,\"R\":%s,\"path\":%s}"
       (Reading.polygons_text o.polygons)
       (Reading.polygons_text r.polygons)
       (path_text path))

let check_claim budget contact_of sides_of step claim_of scene path claim =
  budget 64;
  let kind =
    match claim with
    | Object found -> (
      match List.assoc_opt "claim" found with Some (Text kind) -> kind | _ -> "")
    | _ -> ""
  in
  let the_place () =
    match path with [ x ] -> x | _ -> fail Malformed "the path of the case is not one place"
  in
  let clear value contact scales =
    match step value with
    | Clear clear ->
      demand
        (clear.contact = contact && Cells.same_scales clear.scales scales)
        "the step is about another contact, or other scales";
      clear
    | Pieces _ -> fail Malformed "this is no step `clear`"
  in
  let told_contact = function
    | Reading.Allowed -> "contact allowed"
    | Forbidden -> "contact forbidden"
  in
  let found contact scales by part holds =
    let said =
      Printf.sprintf "%s: at %s, %s" kind (shown_scales scales) (told_contact contact)
    in
    { said; holds; kind; contact; scales; by; part; tests = 0 }
  in
  let names rest = "claim" :: "contact" :: "scales" :: rest in
  let answer member =
    match members claim (names [ member; "claims" ]) with
    | [ _; contact; scales; told; claims ] ->
      let contact = contact_of contact and scales = Reading.scales scales in
      let told = List.map Reading.scales (items told) in
      let parts : claim list = List.map claim_of (items claims) in
      (contact, scales, told, parts)
    | _ -> assert false
  in
  let answered yes kinds (contact, scales, told, parts) part holds =
    require (List.for_all (fun c -> List.mem c.kind kinds) parts) "a claim is of another kind";
    demand (List.for_all (fun c -> c.contact = contact) parts) "a claim is about another contact";
    Ways.demand_order scales told (List.map (fun c -> (c.kind = yes, c.scales)) parts);
    let by = match parts with [] -> fail Malformed "there are no claims" | c :: _ -> c.by in
    if List.exists (fun c -> c.by <> by) parts then
      fail Declined "claims by different pieces are not followed together";
    List.iter (fun c -> budget c.tests) parts;
    let claims = List.map (fun c -> (c.scales, part (Option.get c.part))) parts in
    let said =
      Printf.sprintf "%s: of %s, %s: %s" kind (shown_scales scales) (told_contact contact)
        (shown_list told)
    in
    { said; kind; contact; scales; by; part = None; tests = 0;
      holds = lazy (holds contact scales told (scene by) claims) }
  in
  match kind with
  | "free" -> (
    match members claim (names [ "step" ]) with
    | [ _; contact; scales; at ] ->
      let contact = contact_of contact and scales = Reading.scales scales in
      let { Ways.by; path = its_path; ways; _ } = clear at contact scales in
      demand
        (List.equal Cells.same_movers its_path (List.map Cells.stays path))
        "the step is about another path";
      found contact scales by (Some (Of_path (Checked.is_free ways)))
        (lazy (Checked.free_holds contact scales (scene by) ways))
    | _ -> assert false)
  | "hit" -> (
    match members claim (names [ "by"; "hits" ]) with
    | [ _; contact; scales; by; hits ] ->
      let contact = contact_of contact and scales = Reading.scales scales in
      let by, sides = sides_of by in
      let hits = Hits.hits budget contact scales sides path hits in
      found contact scales by (Some (Of_both hits))
        (lazy (Checked.hit_holds contact scales (scene by) hits))
    | _ -> assert false)
  | "escapes" -> (
    match members claim (names [ "step"; "normal" ]) with
    | [ _; contact; scales; at; normal ] ->
      let contact = contact_of contact and scales = Reading.scales scales in
      let x = the_place () in
      let { Ways.by; path = places; ways; _ } = clear at contact scales in
      demand (Cells.same_movers (List.hd places) (Cells.stays x)) "the way begins elsewhere";
      let places = Ways.freezing scales places and normal = Elaborate.normal normal in
      found contact scales by (Some (Of_place (Checked.gets_away places ways normal)))
        (lazy (Checked.escapes_holds contact scales (scene by) places ways normal))
    | _ -> assert false)
  | "trapped" -> (
    match members claim (names [ "step"; "by"; "ring"; "pairs" ]) with
    | [ _; contact; scales; at; by; ring; pairs ] ->
      let contact = contact_of contact and scales = Reading.scales scales in
      let x = the_place () in
      let { Ways.by = other; path = its_path; ways; _ } = clear at contact scales in
      let same = List.equal Cells.same_movers its_path [ Cells.stays x ] in
      demand same "the step is about another place";
      let by, sides = sides_of by in
      if by <> other then fail Declined "a step by other pieces is not followed";
      let trap = Hits.trap budget contact scales sides ring pairs ways in
      found contact scales by (Some (Of_place (Checked.is_kept trap)))
        (lazy (Checked.trapped_holds contact scales (scene by) trap))
    | _ -> assert false)
  | "valid" ->
    answered "free" [ "free"; "hit" ] (answer "valid")
      (function Of_path c -> c | Of_both hits -> Checked.is_hit hits | Of_place _ -> assert false)
      Checked.valid_holds
  | "trap" ->
    ignore (the_place ());
    answered "trapped" [ "trapped"; "escapes"; "hit" ] (answer "trapped")
      (function Of_place c -> c | Of_both hits -> Checked.collides hits | Of_path _ -> assert false)
      Checked.trap_holds
  | _ -> fail Malformed "there is no such claim"

(* What is proved, in words *)
let check certificate read_case budget =
  let spent = ref 0 in
  let budget tests =
    spent := !spent + tests;
    budget tests
  in
  match
    members certificate
      [ "certificate"; "title?"; "comment?"; "producer?"; "case"; "steps"; "claims" ]
  with
  | [ _; title; comment; producer; case; steps; claims ] ->
    let file, named = Reading.head [ title; comment; producer ] case in
    let r, o, path =
      match read_case file with
      | Object found ->
        let member name =
          match List.assoc_opt name found with
          | Some value -> value
          | None -> fail Malformed ("the case has no " ^ name)
        in
        let path = List.map Reading.point (items (member "path")) in
        require (path <> []) "a path has no place";
        (Reading.operand "R" (member "R"), Reading.operand "O" (member "O"), path)
      | _ -> fail Malformed "this is no case"
    in
    demand (digest r o path = named) "not the case that is certified";
    let contact_of value =
      let found = Reading.contact value in
      require
        (found = Forbidden || not (Reading.is_thin r || Reading.is_thin o))
        "with contact allowed neither may be a point or a segment";
      found
    in
    let operand_of = function
      | "R" -> r
      | "O" -> o
      | _ -> fail Malformed "there is no such operand"
    in
    let given = Array.of_list (items steps) in
    let made = Array.make (Array.length given) None in
    let used = Hashtbl.create 16 in
    let step_before bound value =
      let i = index value bound in
      Hashtbl.replace used i ();
      (i, Option.get made.(i))
    in
    let side name (i, step) =
      match step with
      | Pieces (other, side) when other = name -> (i, side)
      | _ -> fail Malformed "`by` is not of R and O"
    in
    let sides_of bound value =
      let first, second = pair value in
      let i, of_r = side "R" (step_before bound first) in
      let j, of_o = side "O" (step_before bound second) in
      ((i, j), { Ways.of_r; of_o })
    in
    Array.iteri
      (fun i step ->
        within (Printf.sprintf "step %d" i) (fun () ->
            let rule =
              match step with
              | Object found -> (
                match List.assoc_opt "rule" found with Some (Text rule) -> rule | _ -> "")
              | _ -> ""
            in
            let found =
              match rule with
              | "pieces" ->
                let pieces = Pieces.pieces_step operand_of budget step in
                Pieces (pieces.operand.name, Pieces.side pieces budget [ Q.one ])
              | "clear" -> Clear (Ways.clear budget contact_of (sides_of i) path step)
              | _ -> fail Malformed "there is no such rule"
            in
            made.(i) <- Some found))
      given;
    let tiled i =
      match made.(i) with Some (Pieces (_, side)) -> Pieces.tiled side | _ -> assert false
    in
    let scene (i, j) : Checked.scene =
      {
        part = Reading.rings_of r.polygons; obstacles = Reading.rings_of o.polygons; path;
        of_r = tiled i; of_o = tiled j;
      }
    in
    let claims = items claims in
    require (claims <> []) "nothing is claimed";
    let found = Array.make (List.length claims) None in
    let place i = Printf.sprintf "claim %d" i in
    List.iteri
      (fun i claim ->
        let claim_of value = Option.get found.(index value i) in
        let all = Array.length given in
        let step value = snd (step_before all value) in
        let before = !spent in
        let claim =
          within (place i) (fun () ->
              check_claim budget contact_of (sides_of all) step claim_of scene path claim)
        in
        found.(i) <- Some { claim with tests = !spent - before })
      claims;
    require (Hashtbl.length used = Array.length given) "a step is not used";
    require
      (List.length (List.sort_uniq compare (List.map canonical_text claims)) = List.length claims)
      "a claim is made twice";
    List.mapi
      (fun i claim ->
        let { said; holds; _ } = Option.get claim in
        within (place i) (fun () ->
            demand (Lazy.force holds) "the proved checker does not take this for a proof");
        said)
      (Array.to_list found)
  | _ -> assert false
