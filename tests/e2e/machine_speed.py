"""How long this machine takes for what no program can help."""
import mmap
import resource
import time

USUAL_SECONDS_A_PAGE = 1e-6  # what is taken for usual


def pages_of_children():
    """That were handed out to processes that have ended."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_minflt


def seconds_a_page(pages=2048):
    """For the first touch of a page of memory: 12e-6 in one virtual machine."""
    with mmap.mmap(-1, pages * mmap.PAGESIZE) as memory:
        start = time.perf_counter()
        for page in range(pages):
            memory[page * mmap.PAGESIZE] = 1
        return (time.perf_counter() - start) / pages


def excess_seconds(pages):
    """What so many pages take here beyond what is taken for usual."""
    return pages * max(0.0, min(seconds_a_page() for _ in range(3)) - USUAL_SECONDS_A_PAGE)
