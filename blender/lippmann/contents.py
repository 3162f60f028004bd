"""Hashes the contents of a .blend file, so that an unchanged scene is not exported again.

A .blend file is a list of blocks. A datablock (object, mesh, material ...) is one block, followed by the blocks that only it
uses. Blocks are dumps of C structs. The file describes the layout of its structs (SDNA). The hash leaves out two kinds of
members: addresses, which differ between sessions, and the state of the user interface.
"""

import hashlib
import pathlib
import re
import struct
from dataclasses import dataclass, field

import numpy as np

# Struct members that do not affect the exported scene.
STATE = {"ID": {"us", "icon_id", "recalc", "recalc_up_to_undo_push", "recalc_after_undo_push", "session_uuid", "session_uid", "tag", "flag"}, "Object": {"flag", "recalc", "base_flag", "select_id", "lastNeedMapping"},
         "Base": {"flag", "flag_legacy", "flag_from_collection", "local_view_bits"}, "LayerCollection": {"runtime_flag"}, "bNode": {"need_exec", "locx", "locy"}, "bNodeTree": {"cur_index", "update"},
         "IDProperty": {"len", "totallen", "saved", "next", "prev"}, "IDPropertyData": {"group"},
         "RenderData": {"pic", "xsch", "ysch", "size", "cfra", "engine", "im_format"}, "Scene": {"view_settings", "display_settings", "cursor", "flag", "customdata_mask"}}
SKIPPED = {b"TEST", b"REND", b"GLOB", b"USER", b"DNA1", b"ENDB"}  # codes of blocks that do not affect renders


@dataclass
class Struct:
    size: int
    pointers: list = field(default_factory=list)
    state: list = field(default_factory=list)     # (offset, length) of members that the hash leaves out


@dataclass
class Block:
    code: bytes
    address: int
    struct: int
    count: int
    start: int
    length: int


def read_blocks(data):
    """Returns the blocks of an uncompressed .blend file and its pointer size in bytes. Raises ValueError for other files."""
    if bytes(data[:7]) != b"BLENDER":
        raise ValueError("no uncompressed .blend file")
    if bytes(data[7:9]).isdigit():
        at, head = int(data[7:9]), struct.Struct("<4siQqq")
        order = ("code", "struct", "address", "length", "count")
    else:
        at, head = 12, struct.Struct("<4siQii" if data[7:8] == b"-" else "<4siIii")
        order = ("code", "length", "address", "struct", "count")
    found = []
    while True:
        values = dict(zip(order, head.unpack_from(data, at)))
        at += head.size
        found.append(Block(values["code"], values["address"], values["struct"], values["count"], at, values["length"]))
        at += values["length"]
        if values["code"] == b"ENDB":
            return found, 4 if head.size == 20 else 8


def texts(data, at, mark):
    assert data[at:at + 4] == mark, mark
    count = struct.unpack_from("<i", data, at + 4)[0]
    at += 8
    found = []
    for _ in range(count):
        end = data.index(b"\0", at)
        found.append(data[at:end].decode())
        at = end + 1
    return found, at + -at % 4


class Sdna:
    """The struct layouts that a .blend file describes."""

    def __init__(self, data, address_size):
        self.address_size = address_size
        self._names, at = texts(data, data.index(b"NAME", 0, 16), b"NAME")
        self._type_names, at = texts(data, at, b"TYPE")
        self._sizes = struct.unpack_from(f"<{len(self._type_names)}h", data, at + 4)
        at += 4 + 2 * len(self._type_names)
        at += -at % 4
        count = struct.unpack_from("<i", data, at + 4)[0]
        at += 8
        self._layouts = []
        for _ in range(count):
            kind, members = struct.unpack_from("<hh", data, at)
            self._layouts.append((kind, [struct.unpack_from("<hh", data, at + 4 + 4 * i) for i in range(members)]))
            at += 4 + 4 * members
        self._by_type = {kind: index for index, (kind, _) in enumerate(self._layouts)}
        self.types = [self._type_names[kind] for kind, _ in self._layouts]
        self.structs = {}
        for index in range(count):
            self._describe(index)

    def _members(self, index):
        """Yields (name, type, offset, element size in bytes, number of elements, whether they are pointers) for each member of
        a struct."""
        offset = 0
        for kind, name in self._layouts[index][1]:
            text, times = self._names[name], 1
            for number in re.findall(r"\[(\d+)\]", text):
                times *= int(number)
            is_pointer = text.startswith(("*", "("))
            size = self.address_size if is_pointer else self._sizes[kind]
            yield re.sub(r"[\[)].*", "", text.lstrip("*(")), kind, offset, size, times, is_pointer
            offset += size * times

    def _describe(self, index):
        if index in self.structs:
            return self.structs[index]
        known = Struct(self._sizes[self._layouts[index][0]])
        for name, kind, offset, size, times, is_pointer in self._members(index):
            if name in STATE.get(self.types[index], ()) or name.startswith("_pad"):
                known.state.append((offset, size * times))
            elif is_pointer:
                known.pointers += [offset + i * size for i in range(times)]
            elif kind in self._by_type:
                inner = self._describe(self._by_type[kind])
                for i in range(times):
                    known.pointers += [offset + i * size + at for at in inner.pointers]
                    known.state += [(offset + i * size + at, length) for at, length in inner.state]
        self.structs[index] = known
        return known

    def place(self, type_name, member):
        return next((offset, size * times) for name, _, offset, size, times, _ in self._members(self.types.index(type_name)) if name == member)


class Contents:
    """Hashes of the datablocks in a file. `by_name` maps names such as "OBCube" to hashes. `all` is the hash of all
    datablocks."""

    def __init__(self, path, ignored_properties=()):
        """ignored_properties: names of custom properties that the hashes leave out. Raises ValueError if the file has an
        unknown format."""
        data = memoryview(pathlib.Path(path).read_bytes())
        blocks, address_size = read_blocks(data)
        described = next(block for block in blocks if block.code == b"DNA1")
        self._sdna = Sdna(bytes(data[described.start:described.start + described.length]), address_size)
        self._data = data
        self._ignored = {name.encode() for name in ignored_properties}
        owned = self._owned([block for block in blocks if block.code not in SKIPPED])
        self._label(owned)
        self._references = {}
        self.by_name = {name: self._hash(name, own) for name, own in owned.items()}
        self.all = hashlib.blake2b(repr(sorted(self.by_name.items())).encode(), digest_size=16).hexdigest()

    def with_references(self, name):
        """Returns the hash of a datablock and all datablocks it refers to, directly or indirectly."""
        found, todo = set(), [name]
        while todo:
            one = todo.pop()
            if one not in found:
                found.add(one)
                todo += self._references[one]
        return hashlib.blake2b(repr(sorted((one, self.by_name[one]) for one in found)).encode(), digest_size=16).hexdigest()

    def _owned(self, blocks):
        """Returns {name of a datablock: its blocks}. Leaves out ignored properties and active brushes (Blender 4.3 and later)."""
        owned, own, ignored = {}, None, set()
        for block in blocks:
            if block.code != b"DATA":
                own = owned.setdefault(self._name(block), [])
            if block.address in ignored:
                continue
            kind = self._sdna.types[block.struct]
            if kind == "AssetWeakReference" and block.struct:
                ignored.update(self._pointers(block))
                continue
            if kind == "IDProperty":
                name, pointer = self._property(block)
                if name in self._ignored:
                    ignored.add(pointer)
                    continue
            if own is not None:
                own.append(block)
        return owned

    def _bytes(self, block):
        return self._data[block.start:block.start + block.length]

    def _pointers(self, block):
        form = "<Q" if self._sdna.address_size == 8 else "<I"
        return [struct.unpack_from(form, self._bytes(block), at)[0] for at in self._sdna.structs[block.struct].pointers]

    def _text(self, block, at, length):
        return bytes(self._bytes(block)[at:at + length]).split(b"\0")[0]

    def _name(self, block):
        name, length = self._sdna.place("ID", "name")
        return self._text(block, name, length).decode(errors="replace") or block.code.decode(errors="replace")

    def _property(self, block):
        name, length = self._sdna.place("IDProperty", "name")
        data, _ = self._sdna.place("IDProperty", "data")
        return self._text(block, name, length), struct.unpack_from("<Q" if self._sdna.address_size == 8 else "<I", self._bytes(block), data)[0]

    def _label(self, owned):
        """Labels every address by its datablock's name and the block's index. The label is the same in every session."""
        labels, self._datablocks = {}, {}
        for name, own in owned.items():
            self._datablocks[own[0].address] = name
            for index, block in enumerate(own):
                word = hashlib.blake2b(f"{name} {index}".encode(errors="replace"), digest_size=self._sdna.address_size).digest()
                labels[block.address] = int.from_bytes(word, "little")
        kind = np.uint64 if self._sdna.address_size == 8 else np.uint32
        self._addresses = np.array(sorted(labels), kind)
        self._labels = np.array([labels[address] for address in sorted(labels)], kind)

    def _named(self, addresses, otherwise):
        at = np.minimum(np.searchsorted(self._addresses, addresses), len(self._addresses) - 1)
        return np.where(self._addresses[at] == addresses, self._labels[at], otherwise)

    def _refer(self, name, addresses):
        for address in np.unique(addresses):
            if int(address) in self._datablocks:
                self._references[name].add(self._datablocks[int(address)])

    def _hash(self, name, own):
        found = hashlib.blake2b(digest_size=16)
        self._references[name] = set()
        for block in own:
            found.update(f"{self._sdna.types[block.struct]} {block.count} {block.length};".encode())
            found.update(self._canonical(name, block))
        return found.hexdigest()

    def _canonical(self, name, block):
        data, known = self._bytes(block), self._sdna.structs[block.struct]
        word, kind = self._sdna.address_size, self._addresses.dtype
        if block.struct == 0 or known.size * block.count != block.length:  # memory without a struct, such as an array of pointers
            words = np.frombuffer(data[:block.length // word * word], kind)
            self._refer(name, words[np.isin(words, self._addresses)])
            return self._named(words, words).tobytes() + bytes(data[block.length // word * word:])
        if not known.pointers and not known.state:
            return data
        table = np.frombuffer(data, np.uint8).reshape(block.count, known.size).copy()
        for at, length in known.state:
            table[:, at:at + length] = 0
        for at in known.pointers:
            addresses = np.ascontiguousarray(table[:, at:at + word]).view(kind).reshape(-1)
            self._refer(name, addresses)
            table[:, at:at + word] = self._named(addresses, kind.type(0)).view(np.uint8).reshape(-1, word)
        return table.tobytes()
