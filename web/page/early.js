// Written in ES5, so that old browsers can run it. If a browser cannot run the program's own
// script, the page lists the browsers that can.
function tooOld() {
  document.getElementById("words").textContent =
    "This browser is too old for carrom.\n" +
    "carrom needs Chrome or Edge 111, Firefox 113, Safari 16.4, or a later version.";
}
document.addEventListener("DOMContentLoaded", function () {
  if (!window.carrom) tooOld();
});
