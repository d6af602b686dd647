"""Compilation without machine code, for functions that only compiled functions call.

numba optimises each function together with all that it calls, and makes machine code of both;
for a function that is called by another, all this is done again in the caller.  Here such a
function remains LLVM intermediate code, which its callers include.  It is then optimised only
once for each function that Python calls: half the time of compilation.
"""

from typing import Any

from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import LoweringPass, PassManager, register_pass
from numba.core.typed_passes import AnnotateTypes, NativeLowering


class IntermediateCode(JITCodeLibrary):
    """A library of code that is neither optimised nor made machine code."""

    def _optimize_final_module(self) -> None:
        pass

    def _finalize_final_module(self) -> None:
        self._finalized = True


@register_pass(mutates_CFG=False, analysis_only=False)
class ToIntermediateCode(LoweringPass):
    """Have numba make intermediate code only, without entry points for Python or C."""

    _name = "to_intermediate_code"

    def __init__(self) -> None:
        super().__init__()

    def run_pass(self, state: Any) -> bool:
        """Set library and flags before numba generates code."""
        state.library = IntermediateCode(state.targetctx.codegen(), state.func_id.func_qualname)
        for flag in ("no_compile", "no_cpython_wrapper", "no_cfunc_wrapper"):
            setattr(state.flags, flag, True)
        return True


@register_pass(mutates_CFG=False, analysis_only=False)
class FoundByItsCallers(LoweringPass):
    """Register the code of a function for its callers."""

    _name = "found_by_its_callers"

    def __init__(self) -> None:
        super().__init__()

    def run_pass(self, state: Any) -> bool:
        """Register it under a builtin of its own, as numba demands; Python cannot call it."""
        nothing: dict[Any, Any] = {}
        key = nothing.__getitem__
        state.targetctx.insert_user_function(key, state.cr.fndesc, [state.library])
        state.cr = state.cr._replace(cfunc=key)
        return True


class Inner(CompilerBase):
    """numba's compiler, ending with intermediate code."""

    def define_pipelines(self) -> list[PassManager]:
        """Return numba's passes with the two of this module."""
        passes = DefaultPassBuilder.define_nopython_pipeline(self.state)
        passes.add_pass_after(ToIntermediateCode, AnnotateTypes)
        passes.add_pass_after(FoundByItsCallers, NativeLowering)
        passes.finalize()
        return [passes]
