;; A user of Emacs with Eglot and the configuration of docs/guides/editors.md, in a process without a screen. Prints one JSON document.
(require 'package)
(add-to-list 'package-directory-list "/usr/share/emacs/site-lisp/elpa")
(package-initialize)
(load (getenv "CONFIGURATION") nil t)
(require 'json)
(require 'eglot)
(setq eglot-sync-connect 60 eglot-confirm-server-initiated-edits nil make-backup-files nil)

(defun until (met)
  "Wait for the server until MET answers."
  (let ((end (time-add nil 60)) answer)
    (while (and (not (setq answer (funcall met))) (time-less-p nil end))
      (accept-process-output nil 0.1))
    answer))

(defun findings ()
  (flymake-start)
  (mapcar #'flymake-diagnostic-text (flymake-diagnostics)))

(find-file (getenv "FILE"))
(unless (eglot-managed-p) (call-interactively #'eglot))
(let ((found (until #'findings)) offered)
  (search-forward "[6041")
  (eglot-rename "2041")
  (save-buffer)
  ;; the value is typed again: the list has the entries that a TPDO carries
  (goto-char (point-min))
  (search-forward "DefaultValue=0x2041")
  (delete-region (point) (line-end-position))
  (let ((completion (run-hook-with-args-until-success 'completion-at-point-functions)))
    (setq offered (mapcar #'substring-no-properties (all-completions "" (nth 2 completion)))))
  (princ (json-encode `((mode . ,major-mode) (findings . ,(vconcat found)) (offered . ,(vconcat offered))))))
