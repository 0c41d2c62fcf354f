

# Part 5c: components, cavities and tunnels of sums of solids. Needs part 5.

Box = tuple[list[int], list[int]]  # whole numbers not above, and not below, the coordinates
Line = tuple[SpaceVector, Homogeneous]  # a direction, and its cross product with a point


def on_plane(polygon: list[Homogeneous], plane: HalfSpace) -> tuple[list[int], list[Homogeneous]]:
    """The corners' levels above a plane; the polygon's points there: none, one, or both ends of a
    segment."""
    (a, b, c), height = plane
    levels = [a * x + b * y + c * z - height * w for x, y, z, w in polygon]
    points = []
    for k, end in enumerate(polygon):
        s, e = levels[k - 1], levels[k]
        if (s < 0 < e) or (e < 0 < s):
            x, y, z, w = (abs(e) * p + abs(s) * q for p, q in zip(polygon[k - 1], end, strict=True))
            points.append((x, y, z, w))
        elif e == 0:
            points.append(end)
    return levels, points


def share_a_segment(ends: list[list[Homogeneous]], way: SpaceVector) -> bool:
    """Whether two segments on a line along a vector have more than a point in common."""
    places = [[Fraction(dot_in_space(way, p[:3]), p[3]) for p in of] for of in ends]
    return max(map(min, places)) < min(map(max, places))


def box_of(polygon: list[Homogeneous]) -> Box:
    low = [min(p[k] // p[3] for p in polygon) for k in range(3)]
    return low, [max(-(-p[k] // p[3]) for p in polygon) for k in range(3)]


class Shells:
    """The boundary of a solid, cut until its convex parts meet along whole sides, or at points; and
    the closed surfaces to which these are joined."""

    def __init__(self, faces: Tiles, budget: Budget) -> None:
        self.budget = budget
        whole = [(plane, polygon) for plane in sorted(faces) for polygon in faces[plane]]
        self.parts = [
            (plane, part)
            for (plane, polygon), cuts in zip(whole, self.find_cuts(whole), strict=True)
            for part in self.cut(polygon, cuts)
        ]
        self.find_sides()

    def find_cuts(self, whole: list[tuple[HalfSpace, list[Homogeneous]]]) -> list[set[HalfSpace]]:
        """For each part, the planes of others that share a segment with its inside."""
        boxes = [box_of(polygon) for _, polygon in whole]
        order = sorted(range(len(whole)), key=lambda i: boxes[i][0][0])
        cuts: list[set[HalfSpace]] = [set() for _ in whole]
        for n, i in enumerate(order):
            for j in order[n + 1 :]:
                if boxes[j][0][0] > boxes[i][1][0]:
                    break
                self.budget.spend(1)
                apart = any(
                    boxes[i][0][k] > boxes[j][1][k] or boxes[j][0][k] > boxes[i][1][k]
                    for k in (1, 2)
                )
                if not apart:
                    self.add_cuts(whole, cuts, i, j)
        return cuts

    def add_cuts(
        self, whole: list[tuple[HalfSpace, list[Homogeneous]]], cuts: list[set[HalfSpace]],
        i: int, j: int,
    ) -> None:  # fmt: skip
        (one, A), (other, B) = whole[i], whole[j]
        way = cross_in_space(one[0], other[0])
        if not any(way):
            return
        self.budget.spend(len(A) + len(B))
        (of_A, on_A), (of_B, on_B) = on_plane(A, other), on_plane(B, one)
        if len(on_A) > 1 and len(on_B) > 1 and share_a_segment([on_A, on_B], way):
            for k, levels, plane in ((i, of_A, other), (j, of_B, one)):
                if min(levels) < 0 < max(levels):
                    cuts[k].add(max(plane, (negative(plane[0]), -plane[1])))

    def cut(self, polygon: list[Homogeneous], planes: set[HalfSpace]) -> list[list[Homogeneous]]:
        parts = [polygon]
        for normal, height in sorted(planes):
            sides = (normal, height), (negative(normal), -height)
            cut = [below(part, side, self.budget) for part in parts for side in sides]
            parts = [part for part in cut if part]
        return parts

    def find_sides(self) -> None:
        """Numbers all sides of parts, cut where others on their lines end: `next` of each along its
        part, and `mates`, across the inside of the solid and across its outside."""
        on: dict[Line, list[tuple[int, int, Homogeneous, Homogeneous]]] = defaultdict(list)
        rows: list[list[tuple[Line, Homogeneous, Homogeneous]]] = []
        for n, (_, part) in enumerate(self.parts):
            rows.append([(line_through(a, b), a, b) for a, b in edges_of(part)])
            for k, (line, a, b) in enumerate(rows[-1]):
                on[line].append((n, k, a, b))
        place: dict[tuple[Line, Homogeneous], int] = {}
        for line, sides in on.items():
            stops = {p for side in sides for p in side[2:]}
            along = sorted(stops, key=lambda p: Fraction(dot_in_space(line[0], p[:3]), p[3]))
            place.update(((line, p), k) for k, p in enumerate(along))
        around: dict[tuple[Line, int], list[tuple[int, int]]] = defaultdict(list)
        self.of: list[int] = []  # the part of each side
        self.next: list[int] = []
        for n, row in enumerate(rows):
            first = len(self.of)
            for line, a, b in row:
                i, j = place[line, a], place[line, b]
                self.budget.spend(abs(j - i))
                for k in range(i, j) if i < j else range(i - 1, j - 1, -1):
                    around[line, k].append((len(self.of), 1 if i < j else -1))
                    self.of.append(n)
            self.next += [*range(first + 1, len(self.of)), first]
        self.mates = [0] * len(self.of), [0] * len(self.of)
        for (line, _), joined in around.items():
            self.join(line[0], joined)

    def join(self, way: SpaceVector, sides: list[tuple[int, int]]) -> None:
        """Joins the parts around a segment. Seen against its direction the outside is to the left
        of a part that runs along it, and the inside to the left of one that runs back."""
        inward = [self.inward(way, *side) for side in sides]
        along = inward[0]
        across = cross_in_space(way, along)
        turns = [turned_by(dot_in_space(v, along), dot_in_space(v, across)) for v in inward]
        order = [side for _, side in sorted(zip(turns, sides, strict=True))]
        for (h, sign), (other, back) in edges_of(order):
            demand(sign != back, "faces do not bound the sum")
            mates = self.mates[sign > 0]
            mates[h], mates[other] = other, h

    def inward(self, way: SpaceVector, side: int, sign: int) -> SpaceVector:
        v = cross_in_space(self.parts[self.of[side]][0][0], way)
        return v if sign > 0 else negative(v)

    def surfaces(self, mates: list[int]) -> list[tuple[int, bool]]:
        """The genus of each surface, and whether it bounds a volume above zero."""
        root = list(range(len(self.parts)))
        for h, other in enumerate(mates):
            root[find(root, self.of[h])] = find(root, self.of[other])
        shells = [find(root, n) for n in range(len(root))]
        doubled = Counter[int]()  # of the Euler characteristics
        volumes: dict[int, list[Fraction]] = defaultdict(list)
        for shell, part in zip(shells, self.parts, strict=True):
            doubled[shell] += 2
            volumes[shell].append(cone(*part))
        done = [False] * len(mates)
        for start in range(len(mates)):
            doubled[shells[self.of[start]]] -= 1
            if not done[start]:
                doubled[shells[self.of[start]]] += 2
            h = start
            while not done[h]:
                done[h], h = True, self.next[mates[h]]
        found = []
        for shell, twice in doubled.items():
            demand(twice % 4 == 0 and twice <= 4, "faces do not bound the sum")
            found.append(((4 - twice) // 4, added(volumes[shell]) > 0))
        return found


def line_through(a: Homogeneous, b: Homogeneous) -> Line:
    (x, y, z, w), (p, q, r, t) = a, b
    way = shortest((p * w - x * t, q * w - y * t, r * w - z * t))
    way = max(way, negative(way))
    *moment, w = (*cross_in_space(way, (x, y, z)), w)
    divisor = gcd(*moment, w)
    return way, (moment[0] // divisor, moment[1] // divisor, moment[2] // divisor, w // divisor)


def turned_by(x: int, y: int) -> Fraction:
    """Ascends from 0 with the direction's angle, counter-clockwise from that of x > 0, y = 0."""
    part = Fraction(x, abs(x) + abs(y))
    return 1 - part if y >= 0 else 3 + part


def cone(plane: HalfSpace, part: list[Homogeneous]) -> Fraction:
    """Six times the volume between the origin and a part of a face."""
    normal, height = plane
    axis = seen_along(normal)
    u, v = (axis + 1) % 3, (axis + 2) % 3
    ring = [(Fraction(p[u], p[3]), Fraction(p[v], p[3])) for p in part]
    return Fraction(doubled_area(ring) * height, normal[axis])


def added(values: list[Fraction]) -> Fraction:
    while len(values) > 1:
        values = [sum(values[k : k + 2], Fraction(0)) for k in range(0, len(values), 2)]
    return values[0]


def check_numbers(faces: Tiles, claimed: list[Json], budget: Budget) -> str:
    """Components, cavities and tunnels of the solid with these faces, if they are claimed."""
    if claimed == [None] * 3:
        return ""
    shells = Shells(faces, budget)
    inner, outer = map(shells.surfaces, shells.mates)
    found = [
        sum(is_positive for _, is_positive in inner),
        sum(not is_positive for _, is_positive in outer),
        sum(genus for genus, _ in inner),
    ]
    demand([*map(integer, claimed)] == found, "components, cavities or tunnels are not so many")
    return "{} components, {} cavities, {} tunnels, ".format(*found)


MORE["components? cavities? tunnels?"] = check_numbers
