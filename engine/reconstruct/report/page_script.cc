#include <gable/engine/reconstruct/report/page_script.h>

namespace gable {

const char* const kPageScript = R"js(
(() => {
  const table = document.querySelector("table");
  const body = table.tBodies[0];
  const houses = document.querySelector(".houses");
  table.querySelectorAll("th button").forEach((button, column) => {
    button.addEventListener("click", () => {
      const head = button.closest("th");
      const down = head.getAttribute("aria-sort") === "ascending";
      table.querySelectorAll("th").forEach((th) => th.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      const numeric = head.classList.contains("number");
      const key = (row) => {
        const cell = row.cells[column].textContent;
        if (!numeric) return cell;
        const value = parseFloat(cell);
        return Number.isNaN(value) ? -Infinity : value;
      };
      const compare = numeric ? (a, b) => (a < b ? -1 : a > b ? 1 : 0)
                              : (a, b) => a.localeCompare(b, undefined, {numeric: true});
      const rows = [...body.rows];
      const place = new Map(rows.map((row, i) => [row, i]));
      rows.sort((a, b) => (down ? -1 : 1) * compare(key(a), key(b)) || place.get(a) - place.get(b));
      body.append(...rows);
      houses.append(...rows.map((row) => document.getElementById(row.dataset.house)));
    });
  });
})();
)js";

}  // namespace gable
