// Colours of charts and pictures, light and dark. CSS has the same names as variables (style.css); what is drawn asks here.

const LIGHT = {
  dark: false, ink: "#1d2733", muted: "#52606d", grid: "#e3e8ee", axis: "#8895a3", paper: "#ffffff", veil: "rgba(255,255,255,.85)", frame: "#cbd3dc",
  mark: "#444444", limit: "#b97a00", limitText: "#7a5000", reference: "#5d6875", ghost: "#000000", plane: "#3b4754", plate: "#8e9aa8", hatch: "#8b97a4",
};
const DARK = {
  dark: true, ink: "#e6ebf1", muted: "#aab5c1", grid: "#323d49", axis: "#77838f", paper: "#1b232c", veil: "rgba(27,35,44,.85)", frame: "#46525f",
  mark: "#c4ccd4", limit: "#e0a52e", limitText: "#f0c264", reference: "#a9b4c0", ghost: "#ffffff", plane: "#c3ccd6", plate: "#6d7986", hatch: "#74808c",
};

const asked = typeof window === "undefined" ? null : window.matchMedia("(prefers-color-scheme: dark)");
let printing = false;

/** The palette of now: what the reader's system asks for, on paper always the light one. */
export function theme() {
  return asked?.matches && !printing ? DARK : LIGHT;
}

/** Calls `draw` whenever the palette has changed, before a page is printed and after. */
export function onThemeChange(draw) {
  asked?.addEventListener("change", draw);
  const print = (now) => () => {
    printing = now;
    draw();
  };
  window.addEventListener("beforeprint", print(true));
  window.addEventListener("afterprint", print(false));
}
