// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultRow.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace seeds
{

ResultRow::ResultRow(QWidget* parent)
  : QWidget(parent)
{
  this->Text = new QLabel(this);
  this->Text->setObjectName("Text");
  this->Text->setWordWrap(true);
  this->Text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* copy = new QToolButton(this);
  copy->setObjectName("Copy");
  copy->setText(tr("Copy"));
  copy->setToolTip(tr("Copy the result with all its digits"));
  copy->setAutoRaise(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Text, 1);
  row->addWidget(copy);
  this->connect(copy, &QToolButton::clicked, this,
    [this] { QApplication::clipboard()->setText(this->Result.text()); });
  this->setVisible(false);
}

void ResultRow::setResult(const ResultNumbers& result)
{
  this->Result = result;
  const QString notice =
    result.notice.isEmpty() ? QString() : "<br>" + result.notice.toHtmlEscaped();
  this->Text->setText(QString("<b>%1</b>").arg(result.summary.toHtmlEscaped()) + notice);
  const bool hasResult = !result.summary.isEmpty();
  if (hasResult)
  {
    // From the first result on, what is below must not jump when the numbers go and come.
    QSizePolicy policy = this->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    this->setSizePolicy(policy);
  }
  this->setVisible(hasResult);
}

}
