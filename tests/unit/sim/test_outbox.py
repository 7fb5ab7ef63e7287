"""What is posted out of turn goes out as it arrives."""

from sim.outbox import Outbox


def test_things_go_out_by_arrival_and_by_posting_among_equals() -> None:
    sent: list[tuple[int, str]] = []
    outbox: Outbox[str] = Outbox(lambda arrival_ns, thing: sent.append((arrival_ns, thing)))
    for arrival_ns, thing in ((5, "late"), (1, "first"), (1, "second")):
        outbox.post(arrival_ns, thing)
    outbox.deliver(until_ns=1)
    assert sent == [(1, "first"), (1, "second")]
    outbox.post(3, "third")
    outbox.deliver()
    assert sent[2:] == [(3, "third"), (5, "late")]
