(* The components and the holes of a sum, for the proved checker: cells class after class, each
   cell after one that it shares an edge with; and the edges of its rings, as stretches between
   cells. Not trusted. *)

open Failure
open Rings

type found = {
  order : int list;  (* the cells: those covered, the outside, the holes *)
  components : Checked.component list;
  outside : Checked.component;
  holes : Checked.component list;
  rows : Checked.stretch list list list list;  (* of each polygon, ring and edge *)
  beside : int * int -> int * int;  (* the covered cells on the left and on the right of an edge *)
}

(* Edges that leave each point as often as they come to it, as rings. Each edge has a tag. *)
let rings_of edges =
  let leaving = Hashtbl.create 64 in
  List.iter (fun ((u, _) as edge, tag) -> Hashtbl.add leaving u (edge, tag)) edges;
  let rec walk first at ring =
    match Hashtbl.find_opt leaving at with
    | None -> fail Refuted "a hole's rim is not closed"
    | Some (((u, v), _) as step) ->
      Hashtbl.remove leaving u;
      if v = first then List.rev (step :: ring) else walk first v (step :: ring)
  in
  List.filter_map
    (fun ((u, _), _) -> if Hashtbl.mem leaving u then Some (walk u u []) else None)
    edges

(* Cells by the numbers of their corners; polygons in the order that they are claimed in. [corner]
   is a point for the checker, [middle] that of two. *)
let found cells is_covered polygons corner middle =
  let cells = Array.of_list cells and is_covered = Array.of_list is_covered in
  let count = Array.length cells in
  let owner = Hashtbl.create (4 * count) in
  Array.iteri (fun i cell -> List.iter (fun e -> Hashtbl.replace owner e i) (edges_of cell)) cells;
  let across (u, v) = Hashtbl.find_opt owner (v, u) in
  let place = Array.make count 0 in
  let seen = Array.make count false in
  (* A class by breadth: its cells in order, and for each but the first how far back its link is *)
  let gather first =
    let queue = Queue.create () and order = ref [] and links = ref [] and size = ref 1 in
    seen.(first) <- true;
    Queue.add (first, 0) queue;
    while not (Queue.is_empty queue) do
      let cell, own = Queue.pop queue in
      place.(cell) <- own;
      order := cell :: !order;
      List.iter
        (fun (u, v) ->
          match across (u, v) with
          | Some next when is_covered.(next) = is_covered.(cell) && not seen.(next) ->
            seen.(next) <- true;
            Queue.add (next, !size) queue;
            links := (!size - 1 - own, middle u v) :: !links;
            incr size
          | _ -> ())
        (edges_of cells.(cell))
    done;
    (List.rev !order, List.rev !links)
  in
  let firsts =
    List.map
      (fun polygon ->
        let first =
          match polygon with
          | { along = u :: v :: _; _ } :: _ -> Hashtbl.find_opt owner (u, v)
          | _ -> assert false
        in
        match first with
        | Some i when is_covered.(i) && not seen.(i) -> gather i
        | _ -> fail Refuted "a polygon is not a component")
      polygons
  in
  let all = List.init count Fun.id in
  demand
    (List.for_all (fun i -> seen.(i) || not is_covered.(i)) all)
    "a component has no polygon";
  let at_wall i = List.exists (fun edge -> across edge = None) (edges_of cells.(i)) in
  let outside =
    match List.find_opt (fun i -> (not is_covered.(i)) && at_wall i) all with
    | Some i -> gather i
    | None -> fail Refuted "no cell is outside"
  in
  let holes = List.filter_map (fun i -> if seen.(i) then None else Some (gather i)) all in
  let covered = List.concat_map fst firsts and others = List.concat_map fst (outside :: holes) in
  let number = Array.make count 0 in
  let give cells = List.iteri (fun n i -> number.(i) <- n) cells in
  give covered;
  give others;
  let beyond covered edge =
    match across edge with
    | Some i when is_covered.(i) <> covered -> number.(i)
    | _ -> fail Refuted "a ring is not on the boundary"
  in
  let component (order, links) polygon =
    let rim ring = (List.map corner ring.along, List.map (beyond true) (edges_of ring.along)) in
    Checked.component (List.length order) links (List.map rim polygon)
  in
  let edges ring =
    let stretch ((_, v) as edge) =
      match Hashtbl.find_opt owner edge with
      | Some i -> Checked.stretch place.(i) (beyond true edge) (corner v)
      | None -> fail Refuted "a ring is not along cells"
    in
    (* From the last stretch to the first; at a vertex of the ring another edge begins. *)
    let add ((u, _) as edge) (vertices, run, runs) =
      match vertices with
      | vertex :: before when u = vertex ->
        (before, [], (stretch edge :: run) :: runs)
      | _ -> (vertices, stretch edge :: run, runs)
    in
    let _, _, runs = List.fold_right add (edges_of ring.along) (List.rev ring.turns, [], []) in
    runs
  in
  let hole (order, links) =
    let edges =
      List.concat_map
        (fun i ->
          List.filter_map
            (fun edge ->
              match across edge with
              | Some j when not is_covered.(j) -> None
              | _ -> Some (edge, beyond false edge))
            (edges_of cells.(i)))
        order
    in
    let ring steps = (List.map (fun ((u, _), _) -> corner u) steps, List.map snd steps) in
    Checked.component (List.length order) links (List.map ring (rings_of edges))
  in
  let beside edge =
    match (Hashtbl.find_opt owner edge, across edge) with
    | Some i, Some j when is_covered.(i) && is_covered.(j) -> (number.(i), number.(j))
    | _ -> fail Refuted "a segment is not inside the sum"
  in
  {
    order = covered @ others;
    components = List.map2 component firsts polygons;
    outside = Checked.component (List.length (fst outside)) (snd outside) [];
    holes = List.map hole holes;
    rows = List.map (List.map edges) polygons;
    beside;
  }
