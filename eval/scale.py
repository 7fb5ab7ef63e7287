"""Where the metres of a run come from, as people and files are told."""

from __future__ import annotations

from typing import Any

from estimator.estimate import Estimate


def scale_data(estimate: Estimate) -> dict[str, Any] | None:
    """Return what an estimate says of scale as JSON values; None if it says nothing."""
    if estimate.scale is None:
        return None
    return {
        "sigma_percent": round(estimate.scale.sigma_percent, 4),
        "common_sigma_percent": round(estimate.scale.common_sigma_percent, 4),
        "share": {source: round(share, 5) for source, share in estimate.scale.share.items()},
    }


def scale_line(estimate: Estimate) -> str | None:
    """Return one line for a terminal; None if the estimate says nothing of scale."""
    if estimate.scale is None:
        return None
    largest_first = sorted(estimate.scale.share.items(), key=lambda item: -item[1])
    shares = ", ".join(f"{source} {share_text(share)}" for source, share in largest_first)
    common = f"{estimate.scale.common_sigma_percent:.2f} % from the stated camera height"
    return f"scale: sigma {estimate.scale.sigma_percent:.2f} % (at least {common}); from {shares}"


def share_text(share: float) -> str:
    """Write a share as percent; a small one is not written as nothing."""
    return "< 1 %" if 0 < share < 0.01 else f"{100 * share:.0f} %"
