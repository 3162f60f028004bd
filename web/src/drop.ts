// Sends pictures that were dropped on the page or chosen in a dialog to the server, which makes a light field of them.
import { postBytes, postText } from "./data";
import { element, button } from "./elements";
import { Refusal } from "./field";

/** The server accepts requests of at most 1 MB. */
const kPiece = 1 << 20;

interface Dropped {
  title: string;
  files: File[];
}

function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  return new Promise((resolve, reject) => {
    const more = (): void =>
      reader.readEntries((some) => {
        all.push(...some);
        if (some.length > 0) more();
        else resolve(all);
      }, reject);
    more();
  });
}

const fileOf = (entry: FileSystemFileEntry): Promise<File> => new Promise((resolve, reject) => entry.file(resolve, reject));

/** Whether to ignore a file: a hidden file, or a file that file managers and cameras write beside pictures. */
const isLeft = (name: string): boolean => name.startsWith(".") || /^(thumbs\.db|desktop\.ini)$/i.test(name) || /\.(txt|md|pdf|xmp)$/i.test(name);

const inFolder = (files: File[]): File[] => files.filter((file) => !isLeft(file.name));

/** Returns whether dropped data are pictures: several files, a folder, or one picture. Other data may be a calibration. */
export function isOfPictures(data: DataTransfer): boolean {
  const entries = [...data.items].map((item) => item.webkitGetAsEntry());
  return entries.length > 1 || entries.some((entry) => entry?.isDirectory) || [...data.files].some((file) => file.type.startsWith("image/"));
}

/** Must be called from the event handler, because the data are not available later. */
export async function pictures(data: DataTransfer): Promise<Dropped> {
  const entries = [...data.items].map((item) => item.webkitGetAsEntry());
  const files = [...data.files];
  const folder = entries.find((entry) => entry?.isDirectory) as FileSystemDirectoryEntry | undefined;
  if (!folder) return { title: "Pictures", files };
  if (entries.length > 1) throw new Refusal("Drop one folder, or only pictures.");
  const inside = await Promise.all((await entriesOf(folder)).filter((entry) => entry.isFile).map((entry) => fileOf(entry as FileSystemFileEntry)));
  return { title: folder.name, files: inFolder(inside) };
}

/** Sends the files in pieces. progress: called with the share of all bytes that was sent. */
export async function send({ title, files }: Dropped, progress: (share: number) => void): Promise<void> {
  await postText("drop/begin", JSON.stringify({ title, names: files.map((file) => file.name) }));
  const all = files.reduce((sum, file) => sum + file.size, 0);
  let sent = 0;
  for (const [index, file] of files.entries())
    for (let from = 0; from < file.size; from += kPiece) {
      const piece = file.slice(from, from + kPiece);
      await postBytes(`drop/${index}/${from}`, piece);
      sent += piece.size;
      progress(sent / all);
    }
  await postText("drop/show", "{}");
  history.replaceState(null, "", location.pathname);
  location.reload();
}

/** The page without a light field, on which pictures can be dropped. */
export class DropPage {
  private readonly status = element("p", { role: "status" });
  private isBusy = false;

  constructor(parent: HTMLElement) {
    const several = (folder: boolean): void => {
      const input = element("input", { type: "file", multiple: true, webkitdirectory: folder });
      if (!folder) input.accept = "image/*,.exr,.hdr,.ppm,.pgm,.pfm,.tga,.tif,.tiff,.heic";
      input.addEventListener("change", () => {
        const files = [...(input.files ?? [])];
        const title = folder ? (files[0]?.webkitRelativePath.split("/")[0] ?? "Pictures") : "Pictures";
        // files of subfolders have longer paths
        const own = folder ? inFolder(files.filter((file) => file.webkitRelativePath.split("/").length === 2)) : files;
        void this.take(Promise.resolve({ title, files: own }));
      });
      input.click();
    };
    parent.replaceChildren(
      element("h2", {}, "Drop pictures here"),
      element("p", {}, "Two or more pictures of one scene, or a folder of them, sorted by name from the left view to the right."),
      element("div", { className: "buttons" }, button("Choose pictures\u2026", () => several(false)), button("Choose a folder\u2026", () => several(true))),
      this.status,
    );
    parent.hidden = false;
    takeDrops((dropped) => void this.take(dropped));
  }

  private async take(dropped: Promise<Dropped>): Promise<void> {
    if (this.isBusy) return;
    this.isBusy = true;
    try {
      await send(await dropped, (share) => (this.status.textContent = `${Math.round(100 * share)}\u2009%`));
    } catch (error) {
      this.status.textContent = error instanceof Refusal ? error.message : String(error);
    }
    this.isBusy = false;
  }
}

export function takeDrops(take: (dropped: Promise<Dropped>) => void): void {
  window.addEventListener("dragover", (event) => event.preventDefault());
  window.addEventListener("drop", (event) => {
    event.preventDefault();
    if (event.dataTransfer) take(pictures(event.dataTransfer));
  });
}
