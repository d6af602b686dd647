"""Mistakes with files and caches: damage, hashes, permissions, what is read back."""

from ..mutant import Mutant

CHANGED = "tests/files/test_changed_files.py"
KEPT = "tests/cli_scenes/test_kept_kernels.py"
CACHE = "tests/kernels/test_cache_that_fails.py"
USERS = "tests/cli_scenes/test_user_scenes.py"

MUTANTS = (
    Mutant(
        "a digest that nobody looks at",
        "src/nonsmooth/files/json_text.py",
        "elif stated != digest(document):",
        "elif stated is False:",
        (CHANGED,),
    ),
    Mutant(
        "a seal of which only the name is looked at",
        "src/nonsmooth/files/netcdf.py",
        "seal != _seal(file.read(size))",
        "seal[:9] != _seal(file.read(size))[:9]",
        (f"{CHANGED}::test_every_byte_that_is_changed_is_noticed",),
    ),
    Mutant(
        "a failed save leaves a part of a file",
        "src/nonsmooth/whole.py",
        "        temporary.unlink(missing_ok=True)\n",
        "        pass\n",
        ("tests/files/test_files.py::test_a_failed_save_leaves_the_old_file",),
    ),
    Mutant(
        "the equations of a loaded orbit are not checked",
        "src/nonsmooth/files/restore_orbits.py",
        "checks.check(off <= allowed,",
        "checks.check(True,",
        (CHANGED,),
    ),
    Mutant(
        "a folder of kernels is read whatever its seal",
        "solver/scenes/sealed.py",
        "if content.pop(SEAL, None) != _seal(folder.name, content):",
        "if content.pop(SEAL, None) is None:",
        (f"{KEPT}::test_one_digit_that_was_changed",),
    ),
    Mutant(
        "the kernels of one scene are those of another",
        "solver/scenes/sealed.py",
        "digest = hashlib.sha256(name.encode())",
        "digest = hashlib.sha256()",
        (f"{KEPT}::test_the_folder_of_another_scene_is_not_taken",),
    ),
    Mutant(
        "a kernel that others may write to is read",
        "solver/scenes/sealed.py",
        "        check_status(path, os.fstat(file.fileno()))\n",
        "",
        (f"{KEPT}::test_what_others_could_have_written_is_not_run",),
    ),
    Mutant(
        "a folder of another user is trusted",
        "solver/scenes/sealed.py",
        "if owners - trusted - {os.getuid()}:",
        "if False:",
        (f"{KEPT}::test_another_user_does_not_run_what_this_one_kept",),
    ),
    Mutant(
        "compiled code is run whatever its hash",
        "solver/kernels/numba_cache.py",
        "if digest != hash_of(content):",
        "if False:",
        (f"{CACHE}::test_damaged_files_are_compiled_anew",),
    ),
    Mutant(
        "compiled code of one function is run for another",
        "solver/kernels/numba_cache.py",
        'f"{name}\\0{types}\\0".encode() + content',
        "content",
        (f"{CACHE}::test_code_in_the_place_of_another_is_not_run",),
    ),
    Mutant(
        "a damaged cache ends the command",
        "solver/kernels/numba_cache.py",
        "    except Exception:  # pickle raises any, of bytes that are not its own\n"
        "        cached.flush()\n",
        "    except ZeroDivisionError:\n        cached.flush()\n",
        (f"{CACHE}::test_damaged_files_are_compiled_anew",),
    ),
    Mutant(
        "a cache that others could have written is used",
        "solver/kernels/numba_cache.py",
        "    check_private(folder, source)\n",
        "",
        (f"{CACHE}::test_what_others_could_have_written_is_not_run",),
    ),
    Mutant(
        "the hash of a scene leaves out the program",
        "src/nonsmooth/scene_files/content.py",
        "digest = hashlib.sha256(_generator())",
        "digest = hashlib.sha256()",
        (f"{USERS}::test_a_file_is_derived_again_when_it_or_the_program_changes",),
    ),
)
