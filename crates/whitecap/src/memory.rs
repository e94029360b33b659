//! How much memory the process has needed.

/// The most memory that this process ever held, in MiB; `None` where the system does not say.
pub(crate) fn peak_mib() -> Option<f64> {
    // Linux keeps the high-water mark here; elsewhere the file does not exist.
    peak_mib_in(&std::fs::read_to_string("/proc/self/status").ok()?)
}

fn peak_mib_in(status: &str) -> Option<f64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kib: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib / 1024.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_high_water_mark_is_read_in_mib() {
        assert_eq!(peak_mib_in("VmPeak:\t  9999 kB\nVmHWM:\t   2048 kB\nVmRSS:\t 1024 kB\n"), Some(2.0));
    }

    #[test]
    fn a_strange_status_is_no_answer_rather_than_a_wrong_one() {
        for status in ["", "VmHWM:", "VmHWM:\t many kB", "VmHWM:\t 12 pages"] {
            assert_eq!(peak_mib_in(status), None, "{status:?}");
        }
    }
}
