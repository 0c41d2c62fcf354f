(* The components of a sum, for the proved checker: its covered cells, class after class, each cell
   after one that it shares an edge with. Not trusted. *)

open Failure

let edges_of ring =
  let at = Array.of_list ring in
  let n = Array.length at in
  List.init n (fun i -> (at.(i), at.((i + 1) mod n)))

(* Cells and rings by the numbers of their corners; the order of the cells, and the components *)
let components cells is_covered polygons point =
  let cells = Array.of_list cells and is_covered = Array.of_list is_covered in
  let count = Array.length cells in
  let owner = Hashtbl.create (4 * count) in
  Array.iteri (fun i cell -> List.iter (fun e -> Hashtbl.replace owner e i) (edges_of cell)) cells;
  let across (u, v) = Hashtbl.find_opt owner (v, u) in
  let others = List.filter (fun i -> not is_covered.(i)) (List.init count Fun.id) in
  let number = Hashtbl.create 64 in
  List.iteri (fun n i -> Hashtbl.add number i n) others;
  let half = Q.of_ints 1 2 in
  let middle u v =
    let (a, b), (c, d) = (point u, point v) in
    (Q.mul half (Q.add a c), Q.mul half (Q.add b d))
  in
  let seen = Array.make count false in
  (* A class by breadth: its cells in order, and for each but the first how far back its link is *)
  let gather first =
    let queue = Queue.create () and order = ref [] and links = ref [] and size = ref 1 in
    seen.(first) <- true;
    Queue.add (first, 0) queue;
    while not (Queue.is_empty queue) do
      let cell, place = Queue.pop queue in
      order := cell :: !order;
      List.iter
        (fun (u, v) ->
          match across (u, v) with
          | Some next when is_covered.(next) && not seen.(next) ->
            seen.(next) <- true;
            Queue.add (next, !size) queue;
            links := (!size - 1 - place, middle u v) :: !links;
            incr size
          | _ -> ())
        (edges_of cells.(cell))
    done;
    (List.rev !order, List.rev !links)
  in
  let rim polygon =
    let other edge =
      match across edge with
      | Some i when not is_covered.(i) -> Hashtbl.find number i
      | _ -> fail Refuted "a ring is not on the boundary"
    in
    List.map (fun ring -> (List.map point ring, List.map other (edges_of ring))) polygon
  in
  let classes =
    List.map
      (fun polygon ->
        let first =
          match polygon with
          | (u :: v :: _) :: _ -> Hashtbl.find_opt owner (u, v)
          | _ -> fail Malformed "a polygon has no ring"
        in
        match first with
        | Some i when is_covered.(i) && not seen.(i) ->
          let order, links = gather i in
          (order, Checked.component (List.length order) links (rim polygon))
        | _ -> fail Refuted "a polygon is not a component")
      polygons
  in
  demand
    (List.for_all (fun i -> seen.(i) || not is_covered.(i)) (List.init count Fun.id))
    "a component has no polygon";
  (List.concat_map fst classes @ others, List.map snd classes)
