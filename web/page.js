// Loads the viewer, gives it the canvas, and keeps the address at what it shows.

const root = document.documentElement;
const element = (id) => document.getElementById(id);
const water = element("water");

/** What the viewer calls; `Page` in crates/whitecap-viewer/src/host/page.rs says when. */
const page = {
  firstPicture() {
    performance.mark("first-picture");
    root.dataset.state = "ready";
    water.focus({ preventScroll: true });
  },
  at(fragment) {
    history.replaceState(null, "", fragment ? `#${fragment}` : location.pathname + location.search);
    root.dataset.view = fragment;
  },
  wrong(sentence) {
    element("wrong").textContent = sentence;
  },
  done(sentence) {
    element("done").textContent = sentence;
  },
  speak(words) {
    element("spoken").textContent = words;
  },
  failed(sentence) {
    fallback(sentence);
  },
  save(name, bytes) {
    // The bytes are the viewer's memory, which it uses again.
    offer(name, new Blob([bytes.slice()], { type: "application/octet-stream" }));
  },
  saveCanvas(name) {
    water.toBlob((blob) => blob && offer(name, blob), "image/png");
  },
  copy(text) {
    navigator.clipboard?.writeText(text).catch(() => page.done(`Not copied, the browser refuses: ${text}`));
  },
  address(fragment) {
    return new URL(`#${fragment}`, location.href).href;
  },
};

/** Offers a file for download. */
function offer(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Shows which browsers can do it, and pictures. */
function fallback(sentence) {
  root.dataset.state = "fallback";
  element("reason").textContent = sentence;
}

/** Why the water cannot be drawn here; nothing if it can. */
async function obstacle() {
  if (!window.isSecureContext) {
    return "WebGPU is there for pages that come by https or from this machine, and this one does not.";
  }
  if (!navigator.gpu) {
    return "This browser has no WebGPU.";
  }
  const adapter = await navigator.gpu.requestAdapter().catch(() => null);
  return adapter ? undefined : "This browser has WebGPU, but not for this machine's graphics.";
}

/** The response whose bytes are counted as they come. */
function counted(response, seen) {
  let bytes = 0;
  const count = new TransformStream({
    transform(chunk, controller) {
      bytes += chunk.length;
      seen(bytes);
      controller.enqueue(chunk);
    },
  });
  return new Response(response.body.pipeThrough(count), { headers: { "content-type": "application/wasm" } });
}

async function load() {
  const reason = await obstacle();
  if (reason) {
    return fallback(reason);
  }
  const progress = element("progress");
  progress.max = Number(root.dataset.bytes) || 1;
  progress.value = 0;
  const [bindings, response] = await Promise.all([import("./whitecap_web.js"), fetch("whitecap_web_bg.wasm")]);
  if (!response.ok) {
    throw new Error(`whitecap_web_bg.wasm: ${response.status} ${response.statusText}`);
  }
  await bindings.default({ module_or_path: counted(response, (bytes) => (progress.value = bytes)) });
  element("stage").textContent = "Making the sea …";
  progress.removeAttribute("value");
  // Once that is to be seen: the viewer takes the page's only thread for a while.
  await new Promise((seen) => requestAnimationFrame(() => setTimeout(seen)));
  const viewer = new bindings.Viewer(water, page, location.hash);
  addEventListener("hashchange", () => viewer.follow(location.hash));
}

/** Keys that stay the browser's: whole screen, reload, and to go on by Tab after Escape. */
const BROWSERS = new Set(["F5", "F6", "F7", "F11"]);
let leaves = false;
water.addEventListener("keydown", (event) => {
  const command = event.ctrlKey || event.metaKey;
  const isOurs = command ? ["KeyS", "KeyZ"].includes(event.code) : !BROWSERS.has(event.key);
  if (isOurs && !(leaves && event.key === "Tab")) {
    event.preventDefault();
  }
  leaves = event.key === "Escape" || (leaves && event.key === "Shift");
});
water.addEventListener("wheel", (event) => event.preventDefault(), { passive: false });
water.addEventListener("contextmenu", (event) => event.preventDefault());

addEventListener("error", (event) => fallback(`The viewer has stopped, please report it: ${event.message}`));
load().catch((error) => fallback(`The viewer cannot be loaded: ${error.message ?? error}`));
