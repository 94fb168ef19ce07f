// Keeps what the page is made of, so that it opens without a network. What the host has is preferred, so a new version is seen at once.

const CACHE = "objdict-workbench";

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));
self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || new URL(request.url).origin !== self.location.origin) return;
  event.respondWith(
    fetch(request)
      .then(async (response) => {
        if (response.ok) (await caches.open(CACHE)).put(request, response.clone());
        return response;
      })
      .catch(async (error) => (await caches.match(request)) ?? Promise.reject(error)),
  );
});
