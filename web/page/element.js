// An element with attributes and children. `text` is its text; there is no way to give it markup.
export function element(name, attributes = {}, children = []) {
  const result = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'text') result.textContent = value;
    else result.setAttribute(key, value);
  }
  result.append(...children);
  return result;
}
