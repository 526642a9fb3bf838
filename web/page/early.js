// In the script of old browsers (ES5), so that they can run it: where they cannot run the
// program's own script, the page says what it needs.
function tooOld() {
  document.getElementById("words").textContent =
    "This browser is too old for carrom.\n" +
    "It needs Chrome or Edge 111, Firefox 113, Safari 16.4, or a later version.";
}
document.addEventListener("DOMContentLoaded", function () {
  if (!window.carrom) tooOld();
});
