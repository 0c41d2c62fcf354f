// Search without a server. A page that is opened as a file may not start a worker: here one runs in a hidden frame instead.
"use strict";

class IFrameWorker extends EventTarget {
  constructor(url) {
    super();
    const frame = document.body.appendChild(document.createElement("iframe"));
    frame.hidden = true;
    this.inside = frame.contentWindow;
    window.addEventListener("message", (event) => {
      if (event.source === this.inside) this.dispatchEvent(new MessageEvent("message", { data: event.data }));
    });
    this.loaded = new Promise((resolve) => {
      const inside = frame.contentDocument;
      this.inside.postMessage = (data) => this.inside.eval("(data) => parent.postMessage(data, '*')")(data);
      const script = inside.createElement("script");
      script.src = url;
      script.addEventListener("load", resolve);
      inside.head.append(script);
    });
  }

  postMessage(data) {
    this.loaded.then(() => this.inside.dispatchEvent(new MessageEvent("message", { data })));
  }
}

if (location.protocol === "file:") {
  window.IFrameWorker = IFrameWorker; // the script inside asks for this name
  window.Worker = IFrameWorker;
}
