// A worker that runs the same program as the page, which hands it over compiled. From then on the program answers messages.

self.onmessage = async ({ data: { module, glue } }) => {
  const { default: start } = await import(glue);
  await start({ module_or_path: module });
};
