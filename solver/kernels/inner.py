"""Functions that compiled functions alone call: numba makes no machine code of them.

numba optimises each function together with all that it calls, and makes machine code of both.
Of a function that is called by another all that is done again there.  Here such a function
stays as the intermediate code that its callers take over, so that each part is optimised once
for each function that Python calls: half the time of compiling.
"""

from typing import Any

from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import LoweringPass, PassManager, register_pass
from numba.core.typed_passes import AnnotateTypes, NativeLowering


class IntermediateCode(JITCodeLibrary):
    """What a function becomes: neither optimised nor machine code, as its callers will be."""

    def _optimize_final_module(self) -> None:
        pass

    def _finalize_final_module(self) -> None:
        self._finalized = True


@register_pass(mutates_CFG=False, analysis_only=False)
class ToIntermediateCode(LoweringPass):
    """Have numba make intermediate code alone, with no way in from Python or C."""

    _name = "to_intermediate_code"

    def __init__(self) -> None:
        super().__init__()

    def run_pass(self, state: Any) -> bool:
        """Say so before numba makes any code."""
        state.library = IntermediateCode(state.targetctx.codegen(), state.func_id.func_qualname)
        for flag in ("no_compile", "no_cpython_wrapper", "no_cfunc_wrapper"):
            setattr(state.flags, flag, True)
        return True


@register_pass(mutates_CFG=False, analysis_only=False)
class FoundByItsCallers(LoweringPass):
    """Let numba find the code of a function where others call it."""

    _name = "found_by_its_callers"

    def __init__(self) -> None:
        super().__init__()

    def run_pass(self, state: Any) -> bool:
        """Register it by a builtin of its own, as numba demands; Python's call of it fails."""
        nothing: dict[Any, Any] = {}
        key = nothing.__getitem__
        state.targetctx.insert_user_function(key, state.cr.fndesc, [state.library])
        state.cr = state.cr._replace(cfunc=key)
        return True


class Inner(CompilerBase):
    """numba's passes, with intermediate code at the end."""

    def define_pipelines(self) -> list[PassManager]:
        """Return the passes, in their order."""
        passes = DefaultPassBuilder.define_nopython_pipeline(self.state)
        passes.add_pass_after(ToIntermediateCode, AnnotateTypes)
        passes.add_pass_after(FoundByItsCallers, NativeLowering)
        passes.finalize()
        return [passes]
