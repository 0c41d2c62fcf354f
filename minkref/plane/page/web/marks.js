// The marks of the strip: each boundary event, and in colours those of the topology.
const marks = {
  letter: "s",
  scales: data.about,

  groups() {
    const topology = ["touch", "split", "merge", "death", "birth"].map((change) => ({
      id: `marks-${change}`, name: change, isTall: true,
      scales: data.topology.filter((row) => row[2] === change).map((row) => data.about[row[0]]),
    }));
    return [{ id: "marks", name: "mark", isTall: false, scales: data.about }, ...topology];
  },

  bars: (x) => paper.bars(x),
  tell: (event) => `boundary event ${event + 1}: ${exactAndAbout(event)}`,
  go: (event) => goToEvent(event),
};
