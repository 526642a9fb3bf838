// Caches the whole site in the browser, so that it opens without a network. A version of the site
// is cached completely or not at all, and the next version replaces it when no page of the old
// version is open.
"use strict";

const VERSION = "{{version}}";
const FILES = {{files}};

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(VERSION).then((cache) => {
    // Requests the files from the server, not from the browser's own cache.
    return cache.addAll(FILES.map((file) => new Request(file, { cache: "reload" })));
  }));
});

self.addEventListener("activate", (event) => {
  const isOld = (name) => name.startsWith("carrom-") && name !== VERSION;
  event.waitUntil(caches.keys().then((names) => {
    return Promise.all(names.filter(isOld).map((name) => caches.delete(name)));
  }));
});

self.addEventListener("fetch", (event) => {
  if (event.request.method !== "GET") return;
  const request = event.request.url.replace(/index\.html$/, "");
  event.respondWith(caches.match(request, { ignoreSearch: true }).then((kept) => {
    return kept || fetch(event.request);
  }));
});
