// Elements without markup in strings: names from a scene can never become markup.

/** h("button", {class: "a", onclick: f, "aria-label": "x"}, "text", child, ...) */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

let lastId = 0;
export function freshId(stem) {
  lastId += 1;
  return `${stem}-${lastId}`;
}

/** A labelled choice. groups: [{label?, options: [{value, label}]}] */
export function choice(label, groups, value, onchange) {
  const id = freshId("choice");
  const option = (o) => h("option", { value: o.value, selected: o.value === value }, o.label);
  const parts = groups.map((g) => (g.label ? h("optgroup", { label: g.label }, ...g.options.map(option)) : g.options.map(option)));
  return h("span", { class: "choice" }, h("label", { for: id }, label),
    h("select", { id, onchange: (e) => onchange(e.target.value) }, ...parts.flat()));
}

/** A row of buttons of which one is pressed. */
export function toggle(label, options, value, onchange) {
  const buttons = options.map((o) =>
    h("button", {
      type: "button", "aria-pressed": String(o.value === value),
      onclick: () => {
        buttons.forEach((b, i) => b.setAttribute("aria-pressed", String(options[i].value === o.value)));
        onchange(o.value);
      },
    }, o.label));
  return h("span", { class: "toggle", role: "group", "aria-label": label }, ...buttons);
}

export function checkbox(label, checked, onchange) {
  return h("label", { class: "check" }, h("input", { type: "checkbox", checked, onchange: (e) => onchange(e.target.checked) }), label);
}
